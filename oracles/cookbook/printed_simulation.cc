#include "oracles/cookbook/printed_simulation.h"

#include <fmt/format.h>

#include "engine/printed/world.h"

namespace touchstone {
namespace {

namespace printed = cookbook::printed;

printed::Anchor ToPrinted(const Anchor& anchor) {
  using On = printed::Anchor::On;
  const On on = anchor.on == AnchorKind::kBody       ? On::kBody
                : anchor.on == AnchorKind::kParticle ? On::kParticle
                                                     : On::kWorld;
  return {on, anchor.index, anchor.point};
}

printed::Body ToPrinted(const RigidBody& body) {
  printed::Body printed;
  // A body that collides is a sphere or a box. For other bodies the shape only determines
  // the inertia, which is set below.
  if (const auto* box = std::get_if<Box>(&body.placed.shape)) {
    printed.shape = cookbook::Box{box->half_extents};
  } else if (const auto* sphere = std::get_if<Sphere>(&body.placed.shape)) {
    printed.shape = cookbook::Sphere{sphere->radius};
  } else {
    printed.shape = cookbook::Sphere{1};
  }
  printed.mass = body.mass;
  if (body.mass > 0) printed.inertia = InertiaOf(body);
  printed.restitution = body.restitution;
  printed.friction = body.friction;
  printed.force_W = body.force_W;
  printed.collides = body.collides;
  printed.p_WB = body.placed.X_WB.p_WB;
  printed.q_WB = body.placed.X_WB.q_WB
                     ? *body.placed.X_WB.q_WB
                     : Eigen::Quaterniond(body.placed.X_WB.R_WB).normalized();
  printed.v_WB = body.v_WB;
  printed.w_WB = body.w_WB;
  return printed;
}

printed::ClothSprings ToPrinted(const ClothSprings& springs) {
  return {springs.stiffness, springs.damping};
}

class PrintedSimulation final : public Simulation {
 public:
  PrintedSimulation(const World& world, const printed::Errata& errata)
      : dt_(world.dt),
        world_(errata, printed::Settings{.gravity_W = world.gravity_W}),
        particles_(world.particles.size()) {
    for (const RigidBody& body : world.bodies) world_.Add(ToPrinted(body));
    for (const Particle& particle : world.particles) {
      printed::Particle point;
      point.mass = particle.mass;
      point.damping = particle.damping;
      point.bounce = particle.bounce;
      point.p_W = particle.p_W;
      point.v_W = particle.v_W;
      world_.Add(point);
    }
    for (const Spring& spring : world.springs)
      world_.Add(printed::Spring{ToPrinted(spring.A), ToPrinted(spring.B),
                                 spring.stiffness, spring.damping, spring.rest_length});
    for (const DistanceJoint& joint : world.joints)
      world_.Add(
          printed::DistanceJoint{ToPrinted(joint.A), ToPrinted(joint.B), joint.length});
    for (const Cloth& cloth : world.cloths)
      world_.Add(printed::Cloth{cloth.n, cloth.spacing, cloth.centre, cloth.node_mass,
                                cloth.damping, cloth.bounce, ToPrinted(cloth.structural),
                                ToPrinted(cloth.shear), ToPrinted(cloth.bend),
                                cloth.pinned});
  }

  void Push(int body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& J_W) override {
    world_.ApplyImpulse(body, p_W, J_W);
  }

  void Step() override { world_.Step(dt_); }

  void Read(WorldState& state) const override {
    state.bodies.clear();
    for (const printed::Body& body : world_.bodies())
      state.bodies.push_back({body.p_WB, body.q_WB, body.v_WB, body.w_WB});
    state.particles.clear();
    state.nodes.clear();
    for (const printed::Particle& particle : world_.particles()) {
      std::vector<PointState>& points =
          state.particles.size() < particles_ ? state.particles : state.nodes;
      points.push_back({particle.p_W, particle.v_W});
    }
  }

  bool GivesImpulses() const override { return true; }

  void ReadImpulses(std::vector<ContactImpulse>& impulses) const override {
    for (const printed::ContactImpulse& given : world_.impulses()) {
      impulses.push_back(
          {0, given.A, given.B, given.p_WC, given.n_AB_W, given.J_B_W, given.separation});
    }
  }

 private:
  double dt_;
  printed::World world_;
  std::size_t particles_;  // Number of World::particles; the nodes of cloths follow them.
};

}  // namespace

std::unique_ptr<Simulation> BeginPrinted(const World& world,
                                         const printed::Errata& errata) {
  return std::make_unique<PrintedSimulation>(world, errata);
}

void SetPrintedWorldCapabilities(OracleInfo& info) {
  info.simulates = true;
  for (WorldCapability& capability : info.world_capabilities) capability = {true, ""};
  for (const WorldFeature feature :
       {WorldFeature::kCapsule, WorldFeature::kCylinder, WorldFeature::kCone,
        WorldFeature::kConvexHull, WorldFeature::kStaticCapsule,
        WorldFeature::kStaticCylinder, WorldFeature::kStaticCone,
        WorldFeature::kStaticConvexHull, WorldFeature::kStaticHalfSpace}) {
    info.world_capabilities[static_cast<std::size_t>(feature)] = {
        false, fmt::format("the recipes have no {}", NameOf(feature))};
  }
}

}  // namespace touchstone
