#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/worlds/truth/impact.h"

namespace touchstone {

/** The latest impact considered. It exceeds 1, since rounding decides whether an impact
 that falls on a step is detected in it. [steps] */
inline constexpr double kLatestImpact = 1.125;

/** Returns the first moment after an impact at `time`, since the state at that time is
 the one before it. [s] */
inline double JustAfter(double time) {
  return std::nextafter(time, std::numeric_limits<double>::infinity());
}

/** The largest errors that an engine leaves in the state of a body if it applies an
 impact early, late or at another point. */
struct ImpactErrors {
  double velocity = 0;  ///< [m/s]
  double spin = 0;      ///< [rad/s]
  double position = 0;  ///< [m]

  /** Includes the state after an impact that deviates from the truth. */
  void Include(const Striker& deviating, const Striker& truth) {
    velocity = std::max(velocity, (deviating.v_WB - truth.v_WB).norm());
    spin = std::max(spin, (deviating.w_WB - truth.w_WB).norm());
    position = std::max(position, (deviating.p_WB - truth.p_WB).norm());
  }
};

/** Calls `take(impact, inset)` for impacts of engines that detect contacts once per step
 of `h`: from a step before the true `time` to kLatestImpact after it [s], at points that
 lie from none to all of the overlap inside the bodies. `inset`: a part of the overlap.
 [-] */
template <typename Take>
void ForDeviatingImpacts(double time, double h, const Take& take) {
  constexpr int kPhases = 4;
  for (int phase = -kPhases; phase <= kPhases; ++phase) {
    const double late =
        phase == kPhases ? kLatestImpact : static_cast<double>(phase) / kPhases;
    for (const double inset : {0.0, 0.5, 1.0})
      take(std::max(0.0, time + late * h), inset);
  }
}

}  // namespace touchstone
