#include <algorithm>
#include <string>
#include <vector>

#include "scenarios/generators/portable_math.h"
#include "scenarios/generators/worlds/world_builders.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

/** Returns a sphere, a box of any form, or a bar of up to 1 : 20. */
Shape AnyShape(Random& random) {
  const int kind = random.Below(3);
  const double size = random.Uniform(0.1, 0.4);
  const double y = random.Uniform(0.2, 1);
  const double z = random.Uniform(0.2, 1);
  const double thin = random.Uniform(0.05, 0.2);
  if (kind == 0) return Sphere{size};
  if (kind == 1) return Box{size * Vector3d(1, y, z)};
  return Box{size * Vector3d(1, thin, thin)};
}

/** Returns a point of the shape: its centre in one case of four, else inside. [m] */
Vector3d AnyPointOf(const Shape& shape, Random& random) {
  const bool is_centre = random.Below(4) == 0;
  const double x = random.Uniform(-1, 1);
  const double y = random.Uniform(-1, 1);
  const double z = random.Uniform(-1, 1);
  const Vector3d direction = random.Direction();
  if (is_centre) return Vector3d::Zero();
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return sphere->radius * direction;
  return std::get<Box>(shape).half_extents.cwiseProduct(Vector3d(x, y, z));
}

Vector3d AnchorPlace(const World& world, int body, const Vector3d& point) {
  const Pose& X_WB = world.bodies[static_cast<std::size_t>(body)].placed.X_WB;
  return X_WB.p_WB + Apply(X_WB.R_WB, point);
}

/** Adds a rod from any point of body A to any point of body B. */
void AddRod(World& world, int A, int B, Random& random) {
  const auto shape = [&](int i) {
    return world.bodies[static_cast<std::size_t>(i)].placed.shape;
  };
  const Vector3d on_A = AnyPointOf(shape(A), random);
  const Vector3d on_B = AnyPointOf(shape(B), random);
  const Vector3d p_AB_W = AnchorPlace(world, B, on_B) - AnchorPlace(world, A, on_A);
  world.joints.push_back({.A = {AnchorKind::kBody, A, on_A},
                          .B = {AnchorKind::kBody, B, on_B},
                          .length = Norm(p_AB_W)});
}

/** Adds a rod from a point of the world, near body B, to any point of it. */
void AddRodToWorld(World& world, int B, Random& random) {
  const Vector3d on_B =
      AnyPointOf(world.bodies[static_cast<std::size_t>(B)].placed.shape, random);
  const double length = random.Uniform(0.3, 1.5);
  const Vector3d direction = random.Direction();
  world.joints.push_back(
      {.A = {.point = AnchorPlace(world, B, on_B) + length * direction},
       .B = {AnchorKind::kBody, B, on_B},
       .length = Norm(length * direction)});
}

/** Gravity towards the ground, along it as if it were a wall, or none. */
Vector3d AnyGravity(Random& random) {
  const int kind = random.Below(4);
  const Eigen::Vector2d level = random.PlaneDirection();
  if (kind == 0) return Vector3d::Zero();
  if (kind == 1) return kGravity * Vector3d(level.x(), level.y(), 0);
  return {0, 0, -kGravity};
}

}  // namespace

WorldScenario Linkage(WorldDraw& draw) {
  Random& random = draw.random;
  const bool has_loose_body = random.Coin();
  const int linked = 2 + random.Below(has_loose_body ? 4 : 5);
  WorldScenario scenario =
      EmptyWorld(draw, "Bodies on rods, thrown at the ground", random.Uniform(0.3, 0.8));
  World& world = scenario.world;
  world.gravity_W = AnyGravity(random);

  // The bodies, and a rod from each to an earlier one: a tree.
  std::vector<std::string> names;
  for (int i = 0; i < linked + (has_loose_body ? 1 : 0); ++i) {
    const Shape shape = AnyShape(random);
    const double radius = BoundingRadius(shape);
    const int parent = i == 0 ? -1 : random.Below(std::min(i, linked));
    Vector3d p_W = Vector3d::Zero();
    if (parent >= 0) {
      const Body& held = world.bodies[static_cast<std::size_t>(parent)].placed;
      const double distance =
          radius + BoundingRadius(held.shape) + random.Uniform(0.05, 0.6);
      p_W = FreePlace(world, held.X_WB.p_WB, distance, radius, random);
    }
    const bool is_linked = i < linked;
    const std::string name = is_linked ? "body_" + std::to_string(i) : "loose_body";
    if (is_linked) names.push_back(name);
    const double mass = random.Decades(-1, 1);
    const Eigen::Quaterniond q_WB = random.Rotation();
    AddBody(scenario, name, shape, mass, Pose::FromQuaternion(p_W, q_WB));
    if (is_linked && parent >= 0) AddRod(world, parent, i, random);
  }
  // Up to two more rods, which close loops, and up to two to the world.
  for (int more = random.Below(3); more > 0; --more) {
    const int A = random.Below(linked);
    AddRod(world, A, (A + 1 + random.Below(linked - 1)) % linked, random);
  }
  const int to_world = std::max(0, random.Below(5) - 2);
  for (int k = 0; k < to_world; ++k) AddRodToWorld(world, random.Below(linked), random);

  // The linked bodies start with one rigid motion, which stretches no rod. It would
  // stretch those to the world, so they start at rest then.
  const double speed = random.Uniform(0, 6);
  const Vector3d aside = random.Direction();
  const double spin = random.Uniform(0, 6);
  const Vector3d w_W = spin * random.Direction();
  const Vector3d v_W = speed * (Vector3d(0, 0, -1) + 0.7 * aside);
  const Vector3d centre_W = world.bodies.front().placed.X_WB.p_WB;
  for (int i = 0; i < linked && to_world == 0; ++i) {
    RigidBody& body = world.bodies[static_cast<std::size_t>(i)];
    body.w_WB = w_W;
    body.v_WB = v_W + Cross(w_W, body.placed.X_WB.p_WB - centre_W);
  }
  if (has_loose_body) {
    // Thrown at a linked body.
    RigidBody& body = world.bodies.back();
    const RigidBody& at = world.bodies[static_cast<std::size_t>(random.Below(linked))];
    const Vector3d towards_W = Unit(at.placed.X_WB.p_WB - body.placed.X_WB.p_WB);
    const double approach = random.Uniform(1, 8);
    const double own_spin = random.Uniform(0, 10);
    body.v_WB = at.v_WB + approach * towards_W;
    body.w_WB = own_spin * random.Direction();
  }

  // Everything above the ground. It goes 10 m/s · 0.8 s, and not much faster later.
  double lowest = 0;
  for (const RigidBody& body : world.bodies) {
    lowest =
        std::min(lowest, body.placed.X_WB.p_WB.z() - BoundingRadius(body.placed.shape));
  }
  const double above = random.Uniform(0.02, 0.5) - lowest;
  const auto raised = [&](const Vector3d& p_W) -> Vector3d {
    return {p_W.x(), p_W.y(), p_W.z() + above};
  };
  for (RigidBody& body : world.bodies) {
    const Pose& X_WB = body.placed.X_WB;
    body.placed.X_WB = Pose::FromQuaternion(raised(X_WB.p_WB), *X_WB.q_WB);
  }
  for (DistanceJoint& joint : world.joints) {
    if (joint.A.on == AnchorKind::kWorld) joint.A.point = raised(joint.A.point);
  }
  AddGround(scenario, draw, 20);

  const bool are_alike = random.Coin();
  const double restitution = draw.Coefficient();
  SetContacts(scenario, restitution, draw.Coefficient());
  for (RigidBody& body : world.bodies) {
    const double e = draw.Coefficient();
    const double friction = draw.Coefficient();
    if (are_alike) continue;
    body.restitution = e;
    body.friction = friction;
  }
  AddClaim(scenario, "joint_length", names, "a rod keeps its length");
  return scenario;
}

}  // namespace touchstone
