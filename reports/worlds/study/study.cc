#include "reports/worlds/study/study.h"

#include <limits>

#include "reports/worlds/study/world_size.h"

namespace touchstone {

double RoundingOf(const Study& study, double steps) {
  // Roundings that one step may add to a position: a dozen products and sums a coordinate
  // in the force, the velocity and the position, with the contact or joint solver's. They
  // add up from step to step, in the worst case linearly.
  constexpr double kRoundingsOfAStep = 64;
  return kRoundingsOfAStep * study.oracle.unit_roundoff *
         SizeOf(study.scenario.world, study.trajectory) * steps;
}

double UntilOf(const Study& study) {
  return study.scenario.horizon.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace touchstone
