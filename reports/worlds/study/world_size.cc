#include "reports/worlds/study/world_size.h"

#include <algorithm>

namespace touchstone {

double LargestRadius(const World& world) {
  double largest = 0;
  for (const RigidBody& body : world.bodies) {
    if (body.mass > 0) largest = std::max(largest, BoundingRadius(body.placed.shape));
  }
  return largest;
}

double SizeOf(const World& world, const Trajectory& trajectory) {
  double farthest = 0;
  const auto reach = [&](const Eigen::Vector3d& p_W) {
    farthest = std::max(farthest, p_W.cwiseAbs().maxCoeff());
  };
  for (const WorldState& state : trajectory.samples) {
    for (std::size_t i = 0; i < state.bodies.size(); ++i) {
      if (world.bodies[i].mass > 0) reach(state.bodies[i].p_WB);
    }
    for (const PointState& point : state.particles) reach(point.p_W);
    for (const PointState& point : state.nodes) reach(point.p_W);
  }
  return farthest + LargestRadius(world);
}

double SpinSizeOf(const World& world, const Trajectory& trajectory) {
  double largest = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const RigidBody& body = world.bodies[i];
    if (body.mass == 0) continue;
    const Eigen::Vector3d inertia = InertiaOf(body);
    const double unequal = inertia.maxCoeff() / inertia.minCoeff() - 1;
    double fastest = 0;
    for (const WorldState& state : trajectory.samples)
      fastest = std::max(fastest, state.bodies[i].w_WB.norm());
    const double time = world.dt * world.steps;
    largest =
        std::max(largest, BoundingRadius(body.placed.shape) * unequal * fastest * time);
  }
  return largest;
}

}  // namespace touchstone
