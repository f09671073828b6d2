#include "reports/bench/world_quality.h"

#include <cmath>
#include <cstddef>

#include "reports/bench/deepest_penetration.h"

namespace touchstone {
namespace {

// Written so that a NaN counts as the largest.
void TakeLarger(double& largest, double value) {
  if (!(value <= largest) && !std::isnan(largest)) largest = value;
}

}  // namespace

WorldQuality QualityOf(const World& world, const WorldState& state) {
  WorldQuality quality;
  quality.deepest = DeepestPenetration(world, state).depth;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (world.bodies[i].mass == 0) continue;
    Eigen::Vector3d moved = state.bodies[i].p_WB - world.bodies[i].placed.X_WB.p_WB;
    moved.y() = 0;
    TakeLarger(quality.fastest, state.bodies[i].v_WB.norm());
    TakeLarger(quality.sideways, moved.norm());
  }
  return quality;
}

}  // namespace touchstone
