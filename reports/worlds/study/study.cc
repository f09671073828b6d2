#include "reports/worlds/study/study.h"

#include <limits>

#include "reports/worlds/study/world_size.h"

namespace touchstone {

double RoundingOf(const Study& study, double steps) {
  // The roundings that one step may add to a position: a dozen products and sums per
  // coordinate in force, velocity and position, and those of the contact or joint solver.
  // They add up over the steps, linearly in the worst case.
  constexpr double kRoundingsOfAStep = 64;
  return kRoundingsOfAStep * study.oracle.unit_roundoff *
         SizeOf(study.scenario.world, study.trajectory) * steps;
}

double UntilOf(const Study& study) {
  return study.scenario.horizon.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace touchstone
