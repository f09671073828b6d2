#pragma once

#include "reports/finding/finding.h"

namespace touchstone {

/** The share of a size up to which a fault is rounding. [-] */
inline constexpr double kRoundingShare = 1e-6;

/** Returns the grade of a fault that is `share` of the size of its question: kRounding,
 kSmall, kLarge or kGross. A NaN is gross. [-] */
Grade GradeOfShare(double share);

}  // namespace touchstone
