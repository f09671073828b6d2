#include "reports/bench/deepest_penetration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "reports/referee/referee.h"

namespace touchstone {
namespace {

/** Returns the bounding radius; infinite for a half-space. [m] */
double RadiusOf(const Shape& shape) {
  return KindOf(shape) == ShapeKind::kHalfSpace ? HUGE_VAL : BoundingRadius(shape);
}

/** The bounding sphere of a body at its current pose. */
struct Ball {
  std::size_t body;
  Eigen::Vector3d p_W;
  double radius;
};

/** Returns the bounding spheres sorted by their lower end along x, for a sweep. */
std::vector<Ball> SortedBalls(const World& world, const WorldState& state) {
  std::vector<Ball> balls;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (!world.bodies[i].collides) continue;
    balls.push_back({i, state.bodies[i].p_WB, RadiusOf(world.bodies[i].placed.shape)});
  }
  std::sort(balls.begin(), balls.end(), [](const Ball& a, const Ball& b) {
    return a.p_W.x() - a.radius < b.p_W.x() - b.radius;
  });
  return balls;
}

Body AsItIs(const World& world, const WorldState& state, std::size_t body) {
  const BodyState& now = state.bodies[body];
  return {world.bodies[body].placed.shape,
          Pose::FromQuaternion(now.p_WB, now.q_WB.normalized())};
}

}  // namespace

Penetration DeepestPenetration(const World& world, const WorldState& state) {
  Penetration deepest;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const BodyState& body = state.bodies[i];
    if (body.p_WB.allFinite() && body.q_WB.coeffs().allFinite()) continue;
    return {std::numeric_limits<double>::quiet_NaN(), static_cast<int>(i), -1};
  }
  const std::vector<Ball> balls = SortedBalls(world, state);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const double right = balls[i].p_W.x() + balls[i].radius;
    for (std::size_t j = i + 1; j < balls.size(); ++j) {
      if (balls[j].p_W.x() - balls[j].radius > right) break;
      const auto [a, b] = std::minmax(balls[i].body, balls[j].body);
      if (world.bodies[a].mass == 0 && world.bodies[b].mass == 0) continue;
      if ((balls[j].p_W - balls[i].p_W).norm() > balls[i].radius + balls[j].radius)
        continue;
      const ContactTruth truth =
          ComputeContactTruth({AsItIs(world, state, a), AsItIs(world, state, b)});
      const double depth = -(truth.separation.lo + truth.separation.hi) / 2;
      // Written so that a NaN counts as the deepest.
      if (!(depth <= deepest.depth) && !std::isnan(deepest.depth))
        deepest = {depth, static_cast<int>(a), static_cast<int>(b)};
    }
  }
  return deepest;
}

}  // namespace touchstone
