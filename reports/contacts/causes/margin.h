#pragma once

#include <span>
#include <vector>

#include "reports/finding/finding.h"

namespace touchstone {

/** A failed separation: the finding, and by how much it is off, with its sign. */
struct SignedError {
  Finding* finding;
  double error;  ///< separation − truth. [m]
  double truth;  ///< [m]
};

/** How many questions with different truths must show the same error for it to be a
 * margin. */
inline constexpr int kMarginWitnesses = 3;

/** Sets the cause of failed separations, all of one oracle and one pair of shapes, that
 are off by the same amount, to within their tolerances, in at least kMarginWitnesses
 questions whose truths differ by more than that: a margin around the shapes, not a wrong
 computation. */
void ExplainByMargin(std::span<SignedError> errors);

}  // namespace touchstone
