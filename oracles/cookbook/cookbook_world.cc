#include "oracles/cookbook/cookbook_world.h"

#include <type_traits>

#include "engine/dynamics/world.h"
#include "oracles/cookbook/translate.h"

namespace touchstone {
namespace {

cookbook::BodyShape ToBodyShape(const Shape& shape) {
  return std::visit(
      []<class T>(const T& known) -> cookbook::BodyShape {
        if constexpr (kHasRecipe<T>) {
          return ToCookbook(known);
        } else if constexpr (std::is_same_v<T, HalfSpace>) {
          return cookbook::HalfSpace{};
        } else {
          return cookbook::Sphere{1};  // Passes through everything: its shape is unseen.
        }
      },
      shape);
}

cookbook::BodyDefinition ToDefinition(const RigidBody& body) {
  cookbook::BodyDefinition definition;
  definition.shape = ToBodyShape(body.placed.shape);
  definition.state.p_WB = body.placed.X_WB.p_WB;
  definition.state.q_WB = Eigen::Quaterniond(body.placed.X_WB.R_WB).normalized();
  definition.state.v_WB = body.v_WB;
  definition.state.w_WB = body.w_WB;
  definition.mass = body.mass;
  definition.inertia = body.inertia;
  definition.restitution = body.restitution;
  definition.friction = body.friction;
  definition.force_W = body.force_W;
  definition.collides = body.collides;
  return definition;
}

cookbook::Anchor ToAnchor(const Anchor& anchor) {
  return {anchor.on == AnchorKind::kBody ? anchor.index : -1, anchor.point};
}

class CookbookSimulation final : public Simulation {
 public:
  explicit CookbookSimulation(const World& world)
      : world_(SettingsFor(world)), dt_(world.dt) {
    for (const RigidBody& body : world.bodies) world_.AddBody(ToDefinition(body));
    for (const DistanceJoint& joint : world.joints) {
      world_.AddJoint({ToAnchor(joint.A), ToAnchor(joint.B), joint.length});
    }
  }

  void Push(int body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& J_W) override {
    world_.ApplyImpulse(body, p_W, J_W);
  }

  void Step() override { world_.Step(dt_); }

  void Read(WorldState& state) const override {
    state.bodies.resize(static_cast<std::size_t>(world_.body_count()));
    for (int i = 0; i < world_.body_count(); ++i) {
      const cookbook::BodyState& body = world_.state(i);
      state.bodies[static_cast<std::size_t>(i)] = {body.p_WB, body.q_WB, body.v_WB,
                                                   body.w_WB};
    }
    state.particles.clear();
    state.nodes.clear();
  }

  void ReadImpulses(std::vector<ContactImpulse>& impulses) const override {
    std::vector<cookbook::ContactImpulse> read;
    world_.ReadImpulses(read);
    for (const cookbook::ContactImpulse& impulse : read) {
      impulses.push_back({0, impulse.A, impulse.B, impulse.p_WC, impulse.n_AB_W,
                          impulse.J_B_W, impulse.separation});
    }
  }

  bool GivesImpulses() const override { return true; }

 private:
  static cookbook::Settings SettingsFor(const World& world) {
    cookbook::Settings settings;
    settings.gravity_W = world.gravity_W;
    return settings;
  }

  cookbook::World world_;
  double dt_;
};

}  // namespace

decltype(OracleInfo::world_capabilities) CookbookWorldCapabilities() {
  decltype(OracleInfo::world_capabilities) capabilities;
  for (WorldCapability& capability : capabilities) capability.supported = true;
  const auto refuse = [&](WorldFeature feature, const char* reason) {
    capabilities[static_cast<std::size_t>(feature)] = {false, reason};
  };
  refuse(WorldFeature::kOtherShape, "the cookbook moves spheres and boxes");
  refuse(WorldFeature::kStaticOtherShape,
         "the cookbook knows static spheres, boxes and half-spaces");
  refuse(WorldFeature::kParticle, "its particles are not in the world yet");
  refuse(WorldFeature::kSpring, "its springs are not in the world yet");
  refuse(WorldFeature::kCloth, "its cloths are not in the world yet");
  return capabilities;
}

std::vector<Setting> CookbookWorldSettings() {
  return {{"integrator", "mean velocity; RKMK4 at constant angular momentum",
           "flight under a constant force and tumbling without one are exact"},
          {"restitution", "min(e_A, e_B), of the velocity before the step",
           "a bounce at e = 1 keeps the energy at any step"},
          {"friction", "sqrt(mu_A mu_B), circular cone", "Coulomb's law"},
          {"damping", "none", "nothing damps what is not said to be damped"},
          {"sleeping", "none", "nothing sleeps"}};
}

std::unique_ptr<Simulation> BeginCookbookWorld(const World& world) {
  return std::make_unique<CookbookSimulation>(world);
}

}  // namespace touchstone
