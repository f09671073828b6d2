#include "reports/worlds/study/study.h"

#include <limits>

#include "reports/worlds/study/world_size.h"

namespace touchstone {

double RoundingOf(const Study& study, double steps) {
  // The roundings that one step may add to a position: a dozen products and sums per
  // coordinate in force, velocity and position, and those of the contact or joint solver.
  // They add up over the steps, linearly in the worst case.
  constexpr double kRoundingsOfAStep = 64;
  const World& world = study.scenario.world;
  double size = SizeOf(world, study.trajectory);
  // An engine that keeps the angular momentum to its own error takes the spin from it.
  if (study.oracle.documented_rotation_error) size += SpinSizeOf(world, study.trajectory);
  return kRoundingsOfAStep * study.oracle.unit_roundoff * steps * size;
}

double UntilOf(const Study& study) {
  return study.scenario.horizon.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace touchstone
