#pragma once

#include <optional>

#include "reports/finding/finding.h"

namespace touchstone {

/** The excess, in tolerances, beyond which an error is no matter of rounding, however
 much larger it was at first. [-] */
inline constexpr double kClearExcess = 1000;

/** Returns whether `finding` shows the same fault as `original`, found on another
 question: by the same oracle, measure, law, verdict and kind of proof. Its grade must be
 at least as grave. Its value must exceed its tolerance at least half as many times as the
 original did, or kClearExcess times: a fault must not shrink into a rounding.
 @param over If not empty, the value must be over this, and the two rules of size do not
 apply. [unit of the measure] */
bool IsSameFault(const Finding& finding, const Finding& original,
                 std::optional<double> over = std::nullopt);

}  // namespace touchstone
