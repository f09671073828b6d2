#include "oracles/cookbook/cookbook_world.h"

#include <type_traits>

#include <fmt/format.h>

#include "engine/dynamics/world/cloth.h"
#include "engine/dynamics/world/world.h"
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
          return cookbook::Sphere{1};  // Any shape: the body does not collide.
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

cookbook::BodyDefinition ToDefinition(const Particle& particle) {
  cookbook::BodyDefinition definition;
  definition.shape = cookbook::Point{};
  definition.state.p_WB = particle.p_W;
  definition.state.v_WB = particle.v_W;
  definition.mass = particle.mass;
  definition.restitution = particle.bounce;
  definition.drag = particle.damping;
  return definition;
}

cookbook::Cloth ToCookbook(const Cloth& cloth) {
  cookbook::Cloth net;
  net.n = cloth.n;
  net.spacing = cloth.spacing;
  net.centre_W = cloth.centre;
  net.node_mass = cloth.node_mass;
  net.drag = cloth.damping;
  net.bounce = cloth.bounce;
  net.structural = {cloth.structural.stiffness, cloth.structural.damping};
  net.shear = {cloth.shear.stiffness, cloth.shear.damping};
  net.bend = {cloth.bend.stiffness, cloth.bend.damping};
  net.pinned = cloth.pinned;
  return net;
}

// Indices of the parameters.
enum : std::size_t {
  kImpulseIterations,
  kIterationBudget,
  kSinglePrecision,
  kSleepAfter,
  kSleepSpeed,
  kThreads,
  kParameters
};

class CookbookSimulation final : public Simulation {
 public:
  CookbookSimulation(const World& world, std::span<const double> values)
      : world_(SettingsFor(world, values)),
        dt_(world.dt),
        bodies_(static_cast<int>(world.bodies.size())),
        particles_(static_cast<int>(world.particles.size())) {
    for (const RigidBody& body : world.bodies) world_.AddBody(ToDefinition(body));
    for (const Particle& particle : world.particles) {
      world_.AddBody(ToDefinition(particle));
    }
    for (const DistanceJoint& joint : world.joints) {
      world_.AddJoint({ToAnchor(joint.A), ToAnchor(joint.B), joint.length});
    }
    for (const Spring& spring : world.springs) {
      world_.AddSpring({ToAnchor(spring.A), ToAnchor(spring.B), spring.stiffness,
                        spring.damping, spring.rest_length});
    }
    for (const Cloth& cloth : world.cloths) AddCloth(ToCookbook(cloth), world_);
  }

  void Push(int body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& J_W) override {
    world_.ApplyImpulse(body, p_W, J_W);
  }

  void Step() override { world_.Step(dt_); }

  void Read(WorldState& state) const override {
    state.bodies.clear();
    state.particles.clear();
    state.nodes.clear();
    for (int i = 0; i < world_.body_count(); ++i) {
      const cookbook::BodyState& body = world_.state(i);
      if (i < bodies_) {
        state.bodies.push_back({body.p_WB, body.q_WB, body.v_WB, body.w_WB});
      } else {
        std::vector<PointState>& points =
            i < bodies_ + particles_ ? state.particles : state.nodes;
        points.push_back({body.p_WB, body.v_WB});
      }
    }
  }

  void ReadImpulses(std::vector<ContactImpulse>& impulses) const override {
    std::vector<cookbook::ContactImpulse> read;
    world_.AppendContactImpulses(read);
    for (const cookbook::ContactImpulse& impulse : read) {
      impulses.push_back({0, impulse.A, impulse.B, impulse.p_WC, impulse.n_AB_W,
                          impulse.J_B_W, impulse.separation});
    }
  }

  bool GivesImpulses() const override { return true; }

 private:
  static cookbook::Settings SettingsFor(const World& world,
                                        std::span<const double> values) {
    cookbook::Settings settings;
    settings.gravity_W = world.gravity_W;
    settings.impulse_iterations = static_cast<int>(values[kImpulseIterations]);
    settings.iteration_budget = static_cast<int>(values[kIterationBudget]);
    settings.single_precision = values[kSinglePrecision] != 0;
    if (values[kSleepAfter] > 0) settings.sleep_after = values[kSleepAfter];
    settings.sleep_speed = values[kSleepSpeed];
    settings.threads = static_cast<int>(values[kThreads]);
    return settings;
  }

  cookbook::Anchor ToAnchor(const Anchor& anchor) const {
    switch (anchor.on) {
      case AnchorKind::kBody:
        return {anchor.index, anchor.point};
      case AnchorKind::kParticle:
        return {bodies_ + anchor.index, anchor.point};
      case AnchorKind::kWorld:
        break;
    }
    return {-1, anchor.point};
  }

  cookbook::World world_;  // Bodies first, then particles, then nodes of cloths.
  double dt_;
  int bodies_;
  int particles_;
};

}  // namespace

decltype(OracleInfo::world_capabilities) CookbookWorldCapabilities() {
  decltype(OracleInfo::world_capabilities) capabilities;
  for (WorldCapability& capability : capabilities) capability.supported = true;
  for (const WorldFeature feature :
       {WorldFeature::kCapsule, WorldFeature::kCylinder, WorldFeature::kCone,
        WorldFeature::kConvexHull, WorldFeature::kStaticCapsule,
        WorldFeature::kStaticCylinder, WorldFeature::kStaticCone,
        WorldFeature::kStaticConvexHull}) {
    capabilities[static_cast<std::size_t>(feature)] = {
        false, fmt::format("the cookbook has no {}", NameOf(feature))};
  }
  return capabilities;
}

std::vector<Setting> CookbookWorldSettings(CookbookSetup setup) {
  const bool sleeps = setup == CookbookSetup::kSleeping;
  return {
      {"integrator", "mean velocity; RKMK4 at constant angular momentum",
       "flight under a constant force is exact; angular momentum is kept to rounding"},
      {"rods and springs", "discrete gradients in Suzuki's five sub-steps",
       "energy and momenta are kept to rounding; fourth order in time, second order "
       "while anything touches or may collide"},
      {"particles", "reflected at the time of impact with a static box or half-space",
       "no penetration, and no energy loss at bounce 1"},
      {"restitution", "min(e_A, e_B), applied to the velocity before the impact",
       "a bounce at e = 1 conserves energy at any step size"},
      {"impacts",
       "impact of a body in free flight at its time of impact, to 1e-10 of its size",
       "a bounce is not a step late; an impact on an island of more than 32 bodies is "
       "left to the next step"},
      {"friction", "sqrt(mu_A mu_B), circular cone", "Coulomb's law"},
      {"contacts",
       "rigid under a constant load, else a spring and damper (110 Hz, 0.6 s)",
       "piles come to rest; a contact that has carried its load for 24 steps yields when "
       "the load changes"},
      {"damping", "none", "only damping that the world states is applied"},
      sleeps ? Setting{"sleeping", "islands that are slow for sleep_after",
                       "bodies at rest cost nothing; a body that falls asleep loses its "
                       "momentum"}
             : Setting{"sleeping", "none",
                       "bodies never sleep unless sleep_after is chosen"}};
}

std::vector<WorldParameter> CookbookWorldParameters(CookbookSetup setup) {
  const cookbook::Settings shipped;
  std::vector<WorldParameter> parameters(kParameters);
  const auto set = [&](std::size_t index, const char* name, double value, double least,
                       double most, bool whole, const char* what) {
    parameters[index] = {name, value, value, least, most, whole, what, ""};
  };
  set(kImpulseIterations, "iterations", shipped.impulse_iterations, 1, 100'000, true,
      "iterations of every step; Settings::impulse_iterations");
  set(kIterationBudget, "iteration_budget", shipped.iteration_budget, 0, 10'000'000, true,
      "iterations times contacts of a step, until convergence; "
      "Settings::iteration_budget");
  set(kSinglePrecision, "single_precision", shipped.single_precision ? 1 : 0, 0, 1, true,
      "1: floats where no budget is left to converge; Settings::single_precision");
  set(kSleepAfter, "sleep_after", shipped.sleep_after.value_or(0), 0, 1e6, false,
      "time at rest after which islands sleep in s, 0: never; Settings::sleep_after");
  set(kSleepSpeed, "sleep_speed", shipped.sleep_speed, 1e-12, 1e6, false,
      "speed below which a body counts as at rest in m/s; Settings::sleep_speed");
  set(kThreads, "threads", shipped.threads, 1, 64, true,
      "threads of a step; Settings::threads");
  if (setup == CookbookSetup::kSleeping) {
    parameters[kSleepAfter].here = 0.5;
    parameters[kSleepAfter].why = "the oracle shows what sleep does to a motion";
    // A plate on a slope at μ = 0.9985 of its slope's tangent, world/friction/
    // threshold_at_45_degrees, has reached 1e-3 m/s after 0.7 s.
    parameters[kSleepSpeed].here = 1e-4;
    parameters[kSleepSpeed].why =
        "the shipped speed also stops what starts slowly, like a body that just slides";
    parameters[kThreads].here = 2;
    parameters[kThreads].why = "a step has the same bits with any number of threads";
  }
  return parameters;
}

double CookbookSleepSpeed(std::span<const double> values) {
  return values[kSleepAfter] > 0 ? values[kSleepSpeed] : 0;
}

std::unique_ptr<Simulation> BeginCookbookWorld(const World& world,
                                               std::span<const double> values) {
  return std::make_unique<CookbookSimulation>(world, values);
}

std::unique_ptr<Simulation> BeginCookbookWorldInThreads(const World& world, int threads,
                                                        std::span<const double> values) {
  std::vector<double> with_threads(values.begin(), values.end());
  with_threads[kThreads] = threads;
  return BeginCookbookWorld(world, with_threads);
}

}  // namespace touchstone
