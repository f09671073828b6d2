#pragma once

#include "reports/finding/finding.h"

namespace touchstone {

/** The share of a size up to which a fault is rounding. [-] */
inline constexpr double kRoundingShare = 1e-6;

/** Returns the grade of a fault that is `share` of the size of its question: kRounding,
 kSmall, kLarge or kGross. A NaN is gross. [-] */
Grade GradeOfShare(double share);

/** Returns whether a fault is graver than `above`. One without a grade is, so that nobody
 loses a failure by not grading it. */
bool IsGraver(Grade fault, Grade above);

}  // namespace touchstone
