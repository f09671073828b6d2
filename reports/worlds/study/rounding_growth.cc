#include "reports/worlds/study/rounding_growth.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "reports/worlds/study/trajectory_difference.h"
#include "reports/worlds/study/world_size.h"

namespace touchstone {

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
    const double rounding = 2 * growth.gain * RoundingOf(study, time / world.dt);
    if (time >= growth.horizon) continue;
    if (growth.gain > kLargestGain && rounding > discretisation)
      growth.horizon = time;
    else
      growth.gain_before = growth.gain;
  }
  return growth;
}

}  // namespace touchstone
