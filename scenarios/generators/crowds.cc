#include "scenarios/generators/crowds.h"

#include <cmath>
#include <string>

#include "scenarios/generators/random.h"

namespace touchstone {
namespace {

constexpr double kHalf = 0.5;    // Half extent of a box; radius of a sphere. [m]
constexpr double kShift = 0.05;  // Largest random displacement. [m]
// Distance between neighbours in a layer, and between layers. A box turned by 0.1 rad
// about each axis reaches 0.5 (1 + 2 · 0.1) m along an axis, so two boxes that are moved
// towards each other stay apart. [m]
constexpr double kPitch = 1.31;

/** Returns a floor wide enough for bodies that roll off a pile of `count` for a few
 seconds. */
RigidBody Floor(int count) {
  RigidBody floor;
  floor.name = "floor";
  const double half_width = 50 + 2 * std::sqrt(static_cast<double>(count));
  floor.placed.shape = Box{{half_width, 1, half_width}};
  floor.placed.X_WB = Pose::FromQuaternion({0, -1, 0}, Eigen::Quaterniond::Identity());
  floor.mass = 0;
  floor.restitution = 0;
  return floor;
}

World OnFloor(int count) {
  World world;
  world.dt = 1.0 / 240;
  world.steps = 480;
  world.sample_every = 480;
  world.bodies.push_back(Floor(count));
  return world;
}

World Pile(const Shape& shape, int count, std::uint64_t seed) {
  World world = OnFloor(count);
  Random random({seed, static_cast<std::uint64_t>(count)});
  // A row has as many bodies as the pile has layers.
  const int row = static_cast<int>(std::ceil(std::cbrt(static_cast<double>(count))));
  for (int i = 0; i < count; ++i) {
    const int layer = i / (row * row);
    const Eigen::Vector3d cell(i % row - 0.5 * (row - 1), layer,
                               (i / row) % row - 0.5 * (row - 1));
    const Eigen::Vector3d shift(random.Uniform(-kShift, kShift), 0,
                                random.Uniform(-kShift, kShift));
    RigidBody body;
    body.name = "body_" + std::to_string(i);
    body.placed.shape = shape;
    const Eigen::Vector3d p_WB = kPitch * cell + shift + Eigen::Vector3d(0, 0.6, 0);
    // A small rotation, (1, ε) normalised: without libm, so the same on every machine.
    Eigen::Quaterniond q_WB(1, 0.05 * random.Uniform(-1, 1), 0.05 * random.Uniform(-1, 1),
                            0.05 * random.Uniform(-1, 1));
    body.placed.X_WB = Pose::FromQuaternion(p_WB, q_WB.normalized());
    body.restitution = 0;
    world.bodies.push_back(body);
  }
  return world;
}

}  // namespace

World BoxPile(int count, std::uint64_t seed) {
  return Pile(Box{Eigen::Vector3d::Constant(kHalf)}, count, seed);
}

World SpherePile(int count, std::uint64_t seed) {
  return Pile(Sphere{kHalf}, count, seed);
}

World BoxStack(int height) {
  World world = OnFloor(height);
  for (int i = 0; i < height; ++i) {
    RigidBody body;
    body.name = "box_" + std::to_string(i);
    body.placed.shape = Box{Eigen::Vector3d::Constant(kHalf)};
    body.placed.X_WB = Pose::FromQuaternion({0, kHalf + 2 * kHalf * i, 0},
                                            Eigen::Quaterniond::Identity());
    body.restitution = 0;
    world.bodies.push_back(body);
  }
  return world;
}

}  // namespace touchstone
