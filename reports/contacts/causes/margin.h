#pragma once

#include <span>
#include <string>

#include "reports/finding/finding.h"

namespace touchstone {

/** A separation and its signed error. */
struct SignedError {
  Finding* finding;
  double error;       ///< separation − truth. [m]
  double truth;       ///< The certified separation nearest to the answer. [m]
  std::string sizes;  ///< The sizes of the shapes, as a text to compare.
};

/** The number of questions with different truths that must show the same error for it to
 be a margin. [-] */
inline constexpr int kMarginWitnesses = 3;

/** Returns whether the cause of a finding is a margin that ExplainByMargin() found. */
bool IsMargin(const Finding& finding);

/** Sets the cause of failed separations that a margin around the shapes explains. All
 errors belong to one oracle and one pair of kinds of shapes. A margin is one error, to
 within the tolerances, in at least kMarginWitnesses questions whose truths differ by more
 than the tolerances, and between shapes of at least two sizes. It is not a margin if one
 of `passes` is too exact to have it. */
void ExplainByMargin(std::span<SignedError> errors, std::span<const SignedError> passes);

}  // namespace touchstone
