#include "reports/worlds/study/rounding_growth.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "reports/worlds/study/judge_world.h"
#include "reports/worlds/study/trajectory_difference.h"
#include "reports/worlds/study/world_size.h"

namespace touchstone {
namespace {

/** Number of jumps that rounding is granted. A moved start makes a motion jump once, e.g.
 by a fall for as long as a contact is missed. The roundings of later steps, in each of
 two motions that are compared, may make it jump again. */
constexpr double kJumps = 10;

}  // namespace

RoundingGrowth GrowthOf(const Study& study, const Trajectory& nudged) {
  RoundingGrowth growth;
  const double moved = RoundingOf(study, 1);
  if (moved == 0) return growth;
  const World& world = study.scenario.world;
  const double radius = LargestRadius(world);
  const double until = UntilOf(study);
  const std::vector<double> apart =
      DistancesBetween(study.trajectory, nudged, radius, until);
  const std::vector<double> halved =
      DistancesBetween(study.trajectory, *study.half, radius, until);
  double discretisation = 0;
  for (std::size_t s = 0; s < std::min(apart.size(), halved.size()); ++s) {
    const double time = study.trajectory.times[s];
    growth.gain = std::max(growth.gain, apart[s] / moved);
    discretisation = std::max(discretisation, 4 * halved[s]);
    const double rounding = 2 * growth.gain * moved * time / world.dt;
    if (time >= growth.horizon) continue;
    if (growth.gain > kLargestGain && rounding > discretisation)
      growth.horizon = time;
    else
      growth.gain_before = growth.gain;
  }
  return growth;
}

double MostThatRoundingExplains(const Study& study, std::span<const Trajectory> nudged) {
  const double radius = LargestRadius(study.scenario.world);
  std::optional<double> farthest;
  for (const Trajectory& other : nudged) {
    if (!IsWhole(other)) continue;
    const double apart = DistanceBetween(study.trajectory, other, radius, UntilOf(study));
    farthest = std::max(farthest.value_or(0), apart);
  }
  return farthest ? kJumps * *farthest : std::numeric_limits<double>::infinity();
}

}  // namespace touchstone
