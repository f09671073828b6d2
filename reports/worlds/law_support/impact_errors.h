#pragma once

#include <algorithm>

#include "reports/worlds/truth/impact.h"

namespace touchstone {

/** The latest impact considered. It exceeds 1, since rounding decides whether an impact
 that falls on a step is detected in it. [steps] */
inline constexpr double kLatestImpact = 1.125;

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

}  // namespace touchstone
