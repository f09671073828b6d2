#include <algorithm>
#include <cmath>

#include "scenarios/generators/portable_math.h"
#include "scenarios/generators/worlds/world_builders.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

/** The moment of inertia of a solid sphere is this times m r². */
constexpr double kOfSphere = 0.4;

/** A slope: the plane z = 0 turned about y by the angle θ, downhill along its own x. */
struct Slope {
  double tangent;          ///< tan θ.
  Eigen::Quaterniond q_W;  ///< The rotation of the plane.
};

/** Returns a slope of 2° to 38°. */
Slope AnySlope(Random& random) {
  const double half = random.Uniform(0.02, 0.35);  // tan θ/2
  return {2 * half / (1 - half * half), RotationByHalfTangent(Vector3d::UnitY(), half)};
}

/** Tilts everything that was built on the plane z = 0, but not gravity. */
void Tilt(const Slope& slope, World& world) {
  const Vector3d gravity_W = world.gravity_W;
  Turn(slope.q_W, world);
  world.gravity_W = gravity_W;
}

/** Returns the half extents of a box that friction does not tip, as long as it is at most
 `grip` times the load that presses the box down: half its height is at most 0.6 of the
 half width over `grip`. */
Vector3d LowBox(WorldDraw& draw, double grip) {
  Vector3d half = draw.HalfExtents();
  half.z() = std::min(half.z(), 0.6 * std::min(half.x(), half.y()) / grip);
  return half;
}

/** Returns 1 ± δ, with δ from 10^-3 to 1, all decades alike. */
double AwayFromOne(Random& random) {
  const double sign = random.Sign();
  return 1 + sign * random.Decades(-3, 0);
}

/** Returns 0 in half of all cases, as bodies on a plane do not bounce. */
double RestitutionAtRest(Random& random) {
  const bool bounces = random.Coin();
  const double restitution = random.Uniform();
  return bounces ? restitution : 0;
}

}  // namespace

WorldScenario FromRestOnSlope(WorldDraw& draw) {
  Random& random = draw.random;
  const bool is_box = random.Coin();
  WorldScenario scenario = EmptyWorld(
      draw, is_box ? "A box on a slope, from rest" : "A sphere on a slope, from rest",
      random.Uniform(0.3, 1));
  AddGround(scenario, draw, 20);
  const Slope slope = AnySlope(random);
  // Friction never exceeds the pull of gravity along the slope, from which it starts.
  const Vector3d half = LowBox(draw, slope.tangent);
  const Shape shape = is_box ? Shape(Box{half}) : Shape(Sphere{half.x()});
  const double height = is_box ? half.z() : half.x();
  const Pose X_WB = Pose::FromQuaternion({0, 0, height}, TurnedAboutZ(random));
  AddBody(scenario, "body", shape, random.Decades(-1, 1), X_WB);
  // A box slides if μ < tan θ; a sphere slips if μ < tan θ k/(1 + k).
  const double threshold =
      is_box ? slope.tangent : slope.tangent * kOfSphere / (1 + kOfSphere);
  const double friction = threshold * AwayFromOne(random);
  SetContacts(scenario, RestitutionAtRest(random), friction);
  Tilt(slope, scenario.world);
  AddClaim(scenario, "incline", {"body"}, "it starts at rest on a slope");
  return scenario;
}

WorldScenario SlidingBox(WorldDraw& draw) {
  Random& random = draw.random;
  const double speed = random.Uniform(0.5, 3);
  const double friction = random.Uniform(0.1, 1);
  const double stop = speed / (friction * kGravity);  // [s]
  WorldScenario scenario =
      EmptyWorld(draw, "A box slides to a stop", std::min(2.0, 1.2 * stop + 0.1));
  AddGround(scenario, draw, 20);
  const Vector3d half = LowBox(draw, friction);
  const Pose X_WB = Pose::FromQuaternion({0, 0, half.z()}, TurnedAboutZ(random));
  RigidBody& box = AddBody(scenario, "box", Box{half}, random.Decades(-1, 1), X_WB);
  const Eigen::Vector2d heading = random.PlaneDirection();
  box.v_WB = {speed * heading.x(), speed * heading.y(), 0};
  SetContacts(scenario, RestitutionAtRest(random), friction);
  AddClaim(scenario, "slide_to_stop", {"box"}, "it starts flat on level ground");
  return scenario;
}

WorldScenario SlippingSphere(WorldDraw& draw) {
  Random& random = draw.random;
  WorldScenario scenario =
      EmptyWorld(draw, "A sphere slips until it rolls", random.Uniform(0.3, 1));
  AddGround(scenario, draw, 20);
  const double r = random.Uniform(0.05, 0.4);
  const Pose X_WB = Pose::FromQuaternion({0, 0, r}, random.Rotation());
  RigidBody& ball = AddBody(scenario, "ball", Sphere{r}, random.Decades(-1, 1), X_WB);
  const Eigen::Vector2d heading = random.PlaneDirection();
  const double speed = random.Uniform(0.5, 3);
  ball.v_WB = {speed * heading.x(), speed * heading.y(), 0};
  // Less than the speed over the radius, so that it slips at first.
  const double spin = random.Uniform(0, 0.9 * speed / r);
  ball.w_WB = spin * random.Direction();
  const double restitution = RestitutionAtRest(random);
  SetContacts(scenario, restitution, random.Uniform(0.05, 1));
  AddClaim(scenario, "slip_to_roll", {"ball"}, "it starts on level ground");
  return scenario;
}

WorldScenario RollingSphere(WorldDraw& draw) {
  Random& random = draw.random;
  WorldScenario scenario =
      EmptyWorld(draw, "A sphere rolls on a slope", random.Uniform(0.3, 1));
  AddGround(scenario, draw, 20);
  const Slope slope = AnySlope(random);
  const double r = random.Uniform(0.05, 0.4);
  const Pose X_WB = Pose::FromQuaternion({0, 0, r}, random.Rotation());
  RigidBody& ball = AddBody(scenario, "ball", Sphere{r}, random.Decades(-1, 1), X_WB);
  const Eigen::Vector2d heading = random.PlaneDirection();
  const double speed = random.Uniform(0.5, 3);
  ball.v_WB = {speed * heading.x(), speed * heading.y(), 0};
  ball.w_WB = Vector3d(-ball.v_WB.y(), ball.v_WB.x(), 0) / r;  // n × v / r
  const double threshold = slope.tangent * kOfSphere / (1 + kOfSphere);
  const double restitution = RestitutionAtRest(random);
  SetContacts(scenario, restitution, threshold * (1 + random.Decades(-2, 1)));
  Tilt(slope, scenario.world);
  AddClaim(scenario, "rolls", {"ball"}, "it starts without slip, with enough friction");
  return scenario;
}

}  // namespace touchstone
