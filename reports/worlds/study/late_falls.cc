#include "reports/worlds/study/late_falls.h"

#include <algorithm>
#include <cmath>

#include "reports/worlds/law_support/clusters.h"
#include "reports/worlds/law_support/overlap.h"
#include "reports/worlds/law_support/pairs.h"
#include "reports/worlds/study/world_size.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

bool JustTouch(const World& world, const WorldState& start, int A, int B,
               double rounding) {
  if (AreFarApart(PlacedAt(world, start, A), PlacedAt(world, start, B), rounding))
    return false;
  return OverlapOf(world, start, A, B).depth <= rounding &&
         GapBetween(world, start, A, B).length <= rounding;
}

}  // namespace

std::vector<LateFall> LateFallsOf(const Study& study) {
  const World& world = study.scenario.world;
  const WorldState start = StateAtStart(world);
  const double rounding = RoundingOf(study, 1);
  Clusters clusters(world.bodies.size());  // With the number of contacts.
  for (const auto& [A, B] : CollidingPairs(world, SubjectsOf(world, {}))) {
    if (!JustTouch(world, start, A, B, rounding)) continue;
    clusters.Add(A, 1);
    if (world.bodies[static_cast<std::size_t>(B)].mass > 0) clusters.Join(A, B);
  }
  std::vector<LateFall> falls(world.bodies.size());
  for (std::size_t i = 0; i < falls.size(); ++i) {
    const double contacts = clusters.SumAt(static_cast<int>(i));
    if (contacts == 0) continue;
    falls[i] = {world.dt * world.dt * AccelerationOf(world, world.bodies[i]), contacts};
  }
  return falls;
}

Trajectory WithoutLateFalls(Trajectory motion, const Trajectory& reference,
                            const std::vector<LateFall>& falls) {
  const std::size_t samples = std::min(motion.samples.size(), reference.samples.size());
  for (std::size_t s = 0; s < samples; ++s) {
    for (std::size_t i = 0; i < falls.size(); ++i) {
      const Eigen::Vector3d& fall_W = falls[i].each_W;
      if (fall_W.isZero(0)) continue;
      Eigen::Vector3d& p_W = motion.samples[s].bodies[i].p_WB;
      const Eigen::Vector3d off_W = p_W - reference.samples[s].bodies[i].p_WB;
      const double whole = std::round(2 * off_W.dot(fall_W) / fall_W.squaredNorm()) / 2;
      p_W -= std::clamp(whole, -falls[i].most, falls[i].most) * fall_W;
    }
  }
  return motion;
}

}  // namespace touchstone
