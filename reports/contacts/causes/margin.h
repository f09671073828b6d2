#pragma once

#include <span>
#include <vector>

#include "reports/finding/finding.h"

namespace touchstone {

/** A failed separation and its signed error. */
struct SignedError {
  Finding* finding;
  double error;  ///< separation − truth. [m]
  double truth;  ///< The certified separation nearest to the answer. [m]
};

/** The number of questions with different truths that must show the same error for it to
 be a margin. [-] */
inline constexpr int kMarginWitnesses = 3;

/** Sets the cause of failed separations that a margin around the shapes explains. All
 errors belong to one oracle and one pair of shapes. A margin is one error, to within the
 tolerances, in at least kMarginWitnesses questions whose truths differ by more than the
 tolerances. */
void ExplainByMargin(std::span<SignedError> errors);

}  // namespace touchstone
