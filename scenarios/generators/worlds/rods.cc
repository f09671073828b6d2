#include <cmath>

#include "scenarios/generators/portable_math.h"
#include "scenarios/generators/worlds/world_builders.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

/** A point at the end of a rod, as seen from the other end, with its velocity. */
struct Swing {
  Vector3d arm_W;  ///< [m]
  Vector3d v_W;    ///< [m/s]
};

/** Returns a rod of 0.3 to 1.5 m at up to 150° from straight down, which swings in a
 vertical plane; half of all start at rest. */
Swing AnySwing(Random& random) {
  const double length = random.Uniform(0.3, 1.5);
  const Eigen::Vector2d heading = random.PlaneDirection();
  Eigen::Vector2d angle = random.PlaneDirection();  // (sin θ, cos θ)
  while (angle.y() < -0.866) angle = random.PlaneDirection();
  const bool moves = random.Coin();
  const double rate = random.Uniform(-3, 3);
  const double speed = moves ? length * rate : 0;
  const double sine = angle.x();
  const double cosine = angle.y();
  return {length * Vector3d(sine * heading.x(), sine * heading.y(), -cosine),
          speed * Vector3d(cosine * heading.x(), cosine * heading.y(), sine)};
}

/** Adds a mass that touches nothing: a particle, or a spinning box in two cases of three.
 Returns its anchor. */
Anchor AddMass(WorldScenario& scenario, WorldDraw& draw, const std::string& name,
               double mass, const Vector3d& p_W, const Vector3d& v_W) {
  Random& random = draw.random;
  World& world = scenario.world;
  const bool is_particle = random.Below(3) == 0;
  const Vector3d half = draw.HalfExtents();
  const Eigen::Quaterniond q_WB = random.Rotation();
  const double spin = random.Uniform(0, 5);
  const Vector3d w_W = spin * random.Direction();
  if (is_particle) {
    world.particles.push_back({.name = name, .p_W = p_W, .v_W = v_W, .mass = mass});
    return {.on = AnchorKind::kParticle,
            .index = static_cast<int>(world.particles.size()) - 1};
  }
  RigidBody& body =
      AddBody(scenario, name, Box{half}, mass, Pose::FromQuaternion(p_W, q_WB));
  body.v_WB = v_W;
  body.w_WB = w_W;
  body.collides = false;
  return {.on = AnchorKind::kBody, .index = static_cast<int>(world.bodies.size()) - 1};
}

/** Same as StartOf(), with a fixed order of summation. */
Vector3d PlaceOf(const World& world, const Anchor& anchor) {
  if (anchor.on != AnchorKind::kBody) return StartOf(world, anchor);
  const Pose& X_WB = world.bodies[static_cast<std::size_t>(anchor.index)].placed.X_WB;
  return X_WB.p_WB + Apply(X_WB.R_WB, anchor.point);
}

void AddRod(World& world, const Anchor& A, const Anchor& B) {
  const Vector3d p_AB_W = PlaceOf(world, B) - PlaceOf(world, A);
  world.joints.push_back({.A = A, .B = B, .length = Norm(p_AB_W)});
}

}  // namespace

WorldScenario Pendulum(WorldDraw& draw) {
  Random& random = draw.random;
  WorldScenario scenario = EmptyWorld(draw, "A pendulum", random.Uniform(0.3, 1));
  const Vector3d pivot_W = random.Direction();
  const Swing swing = AnySwing(random);
  const Anchor bob = AddMass(scenario, draw, "bob", random.Decades(-1, 1),
                             pivot_W + swing.arm_W, swing.v_W);
  AddRod(scenario.world, {.point = pivot_W}, bob);
  AddClaim(scenario, "pendulum", {"bob"}, "the rod holds it at its centre");
  AddClaim(scenario, "joint_length", {"bob"}, "a rod keeps its length");
  return scenario;
}

WorldScenario DoublePendulum(WorldDraw& draw) {
  Random& random = draw.random;
  WorldScenario scenario =
      EmptyWorld(draw, "A double pendulum", random.Uniform(0.3, 0.8));
  const Vector3d pivot_W = random.Direction();
  const Swing first = AnySwing(random);
  const Swing second = AnySwing(random);
  const double mass = random.Decades(-1, 1);
  const double ratio = draw.Ratio();
  const bool heavy_below = random.Coin();
  const Vector3d upper_W = pivot_W + first.arm_W;
  const Anchor upper = AddMass(scenario, draw, "upper", heavy_below ? mass : mass * ratio,
                               upper_W, first.v_W);
  const Anchor lower = AddMass(scenario, draw, "lower", heavy_below ? mass * ratio : mass,
                               upper_W + second.arm_W, first.v_W + second.v_W);
  AddRod(scenario.world, {.point = pivot_W}, upper);
  AddRod(scenario.world, upper, lower);
  // A light mass between two taut rods snaps through faster than most steps can follow,
  // and two motions that have lost the phase then differ by any amount.
  if (!heavy_below || ratio <= 10) {
    AddClaim(scenario, "pendulum", {"upper", "lower"},
             "rods hold the masses at their centres");
  }
  AddClaim(scenario, "joint_length", {"upper", "lower"}, "a rod keeps its length");
  return scenario;
}

WorldScenario HangingBars(WorldDraw& draw) {
  Random& random = draw.random;
  const bool are_two = random.Coin();
  WorldScenario scenario = EmptyWorld(
      draw, are_two ? "Two bars that hang by rods" : "A bar that hangs by rods",
      random.Uniform(0.3, 1));
  World& world = scenario.world;
  const Vector3d centre_W = random.Direction();
  std::vector<std::string> names;
  const double mass = random.Decades(-1, 1);
  const double ratio = draw.Ratio();
  const bool heavy_below = random.Coin();
  double upper_half_length = 0;
  for (int i = 0; i < (are_two ? 2 : 1); ++i) {
    const double half_length = random.Uniform(0.2, 0.5);
    const double half_width = random.Uniform(0.02, 0.1);
    if (i == 0) upper_half_length = half_length;
    const Vector3d p_W = centre_W - i * Vector3d(0, 0, 0.6);
    // Level when it starts, or tilted by up to 0.2 rad.
    const Eigen::Quaterniond heading = TurnedAboutZ(random);
    const Vector3d axis = random.Direction();
    const Eigen::Quaterniond tilt = RotationByHalfTangent(axis, random.Uniform(0, 0.1));
    names.push_back(i == 0 ? "bar" : "lower_bar");
    const bool is_heavy = are_two && (i == 1) == heavy_below;
    RigidBody& bar =
        AddBody(scenario, names.back(), Box{{half_length, half_width, half_width}},
                is_heavy ? mass * ratio : mass,
                Pose::FromQuaternion(p_W, Product(tilt, heading)));
    bar.collides = false;
    for (const double end : {-half_length, half_length}) {
      const Anchor on_bar{.on = AnchorKind::kBody, .index = i, .point = {end, 0, 0}};
      Anchor above;
      if (i == 0) {
        // Somewhere above the end of the bar.
        const double aside = random.Uniform(0, 0.4);
        above.point =
            PlaceOf(world, on_bar) + Vector3d(0, 0, 0.8) + aside * random.Direction();
      } else {
        above = {.on = AnchorKind::kBody,
                 .index = 0,
                 .point = {std::copysign(upper_half_length, end), 0, 0}};
      }
      AddRod(world, above, on_bar);
    }
  }
  AddClaim(scenario, "joint_length", names, "a rod keeps its length");
  AddClaim(scenario, "conserves_energy", names, "rods do no work");
  return scenario;
}

}  // namespace touchstone
