#include <cmath>

#include "scenarios/generators/portable_math.h"
#include "scenarios/generators/worlds/world_builders.h"

namespace touchstone {
namespace {

Eigen::Vector3d AnyVelocity(Random& random, double most) {
  const double speed = random.Uniform(0, most);
  return speed * random.Direction();
}

}  // namespace

WorldScenario StraightDrop(WorldDraw& draw) {
  Random& random = draw.random;
  const bool is_box = random.Coin();
  WorldScenario scenario = EmptyWorld(draw,
                                      is_box ? "A flat box falls straight onto the ground"
                                             : "A sphere falls straight onto the ground",
                                      random.Uniform(0.5, 1.5));
  AddGround(scenario, draw, 5);
  const Eigen::Vector3d half = draw.HalfExtents();
  const double height = is_box ? half.z() : half.x();
  const double x = random.Uniform(-1, 1);
  const double y = random.Uniform(-1, 1);
  const double gap = random.Uniform(0.02, 1);
  const Pose X_WB = Pose::FromQuaternion({x, y, height + gap}, TurnedAboutZ(random));
  RigidBody& body =
      AddBody(scenario, "body", is_box ? Shape(Box{half}) : Shape(Sphere{half.x()}),
              random.Decades(-1, 1), X_WB);
  body.v_WB.z() = random.Uniform(-2, 1);
  const double restitution = draw.Coefficient();
  SetContacts(scenario, restitution, draw.Coefficient());
  AddClaim(scenario, "bounce_series", {"body"},
           "it starts without spin, and moves along gravity and the normal");
  return scenario;
}

WorldScenario TumblingDrop(WorldDraw& draw) {
  Random& random = draw.random;
  const bool is_box = random.Below(3) < 2;
  WorldScenario scenario = EmptyWorld(draw,
                                      is_box ? "A tumbling box falls onto the ground"
                                             : "A spinning sphere falls onto the ground",
                                      random.Uniform(0.5, 1.5));
  // It goes 3 m/s · 1.5 s in flight, and not much faster later.
  AddGround(scenario, draw, 20);
  const Eigen::Vector3d half = draw.HalfExtents();
  const Shape shape = is_box ? Shape(Box{half}) : Shape(Sphere{half.x()});
  const double gap = random.Uniform(0.02, 1);
  const Pose X_WB =
      Pose::FromQuaternion({0, 0, BoundingRadius(shape) + gap}, random.Rotation());
  RigidBody& body = AddBody(scenario, "body", shape, random.Decades(-1, 1), X_WB);
  body.v_WB = AnyVelocity(random, 3);
  body.w_WB = AnyVelocity(random, 10);
  const double restitution = draw.Coefficient();
  SetContacts(scenario, restitution, draw.Coefficient());
  AddClaim(scenario, "coulomb_cone", {"body"}, "every contact obeys Coulomb's law");
  return scenario;
}

WorldScenario FreeFlight(WorldDraw& draw) {
  Random& random = draw.random;
  WorldScenario scenario =
      EmptyWorld(draw, "A box in free flight", random.Uniform(0.3, 1));
  const Eigen::Vector3d half = draw.HalfExtents();
  const Eigen::Vector3d p_W = random.Direction();
  const Pose X_WB = Pose::FromQuaternion(p_W, random.Rotation());
  RigidBody& body = AddBody(scenario, "body", Box{half}, random.Decades(-1, 1), X_WB);
  body.v_WB = AnyVelocity(random, 5);
  body.w_WB = AnyVelocity(random, 10);
  AddClaim(scenario, "ballistic", {"body"}, "nothing touches it");
  AddClaim(scenario, "torque_free", {"body"}, "gravity acts at its centre");
  return scenario;
}

}  // namespace touchstone
