#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scenarios/generators/portable_math.h"
#include "scenarios/generators/worlds/world_builders.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

/** The most that a body turns in a step. [rad] */
constexpr double kMostTurn = 1.5;

/** Returns a box, a bar or a plate, thin ones down to 1 : 50. */
Box AnyBox(Random& random) {
  const int kind = random.Below(3);
  const double size = random.Uniform(0.1, 0.5);
  const double y = random.Uniform(0.2, 1);
  const double z = random.Uniform(0.2, 1);
  const double thin = random.Uniform(0.02, 0.2);
  if (kind == 0) return {size * Vector3d(1, y, z)};
  if (kind == 1) return {size * Vector3d(1, thin, thin)};
  return {size * Vector3d(1, y, thin)};
}

Vector3d AnySpin(WorldDraw& draw) {
  const double spin = std::min(draw.random.Decades(-1, 2), kMostTurn / draw.dt);
  return spin * draw.random.Direction();
}

}  // namespace

WorldScenario Bars(WorldDraw& draw) {
  Random& random = draw.random;
  const bool is_first_fixed = random.Coin();
  const bool has_gravity = random.Coin();
  const int count = 2 + random.Below(3);
  WorldScenario scenario =
      EmptyWorld(draw, "Boxes, bars and plates spin at each other", 0.6);
  if (!has_gravity) scenario.world.gravity_W.setZero();
  const Box first = AnyBox(random);
  const double reach = BoundingRadius(first);
  const double mass = is_first_fixed ? 0 : random.Decades(-1, 1);
  AddBody(scenario, "body_0", first, mass,
          Pose::FromQuaternion(Vector3d::Zero(), random.Rotation()));
  if (!is_first_fixed) scenario.world.bodies.back().w_WB = AnySpin(draw);
  std::vector<std::string> moving;
  if (!is_first_fixed) moving.emplace_back("body_0");
  for (int i = 1; i < count; ++i) {
    const Box shape = AnyBox(random);
    const double radius = BoundingRadius(shape);
    const double distance = reach + radius + random.Uniform(0.02, 0.5);
    const Vector3d p_W =
        FreePlace(scenario.world, Vector3d::Zero(), distance, radius, random);
    // It misses the centre of the first body by up to both radii.
    const double miss = random.Uniform(0, reach + radius);
    const Vector3d aim_W = miss * random.Direction();
    const double speed = random.Uniform(1, 8);
    const double own_mass = random.Decades(-1, 1);
    moving.push_back("body_" + std::to_string(i));
    RigidBody& body = AddBody(scenario, moving.back(), shape, own_mass,
                              Pose::FromQuaternion(p_W, random.Rotation()));
    body.v_WB = speed * Unit(aim_W - p_W);
    body.w_WB = AnySpin(draw);
  }
  const double restitution = draw.Coefficient();
  SetContacts(scenario, restitution, draw.Coefficient());
  if (is_first_fixed || has_gravity) {
    AddClaim(scenario, "coulomb_cone", moving, "every contact obeys Coulomb's law");
  } else {
    AddClaim(scenario, "conserves_momentum", moving, "no force acts from outside");
  }
  return scenario;
}

}  // namespace touchstone
