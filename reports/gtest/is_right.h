#pragma once

#include <vector>

#include <gtest/gtest.h>

#include "oracles/stated_tolerance.h"
#include "reports/gtest/contact_complaint.h"

namespace touchstone {

/** The tolerance that a test grants to the routine that it checks. */
struct Granted {
  /** The error beyond rounding; it replaces a tolerance of the routine itself. Without
   `by`, the report says that the test states it. */
  StatedTolerance tolerance = {};
};

/** Returns whether `subject` answers every question of the series within the derived
 tolerance of the certified truth. A failure shows the first wrong question, made
 smaller while its fault persists, as a file, the answers of `subject` and `references`
 side by side, the proofs, and the command that repeats it:
      EXPECT_TRUE(IsRight(*mine, {.A = ShapeKind::kBox, .B = ShapeKind::kBox}, {fcl}));
 A wrong reference is shown as wrong, and does not make the subject fail. A routine that
 is meant to be right to a tenth of a millimetre:
      EXPECT_TRUE(IsRight(*mine, series, {fcl}, {.tolerance = {.length = 1e-4}})); */
inline testing::AssertionResult IsRight(const Oracle& subject,
                                        const QuestionSeries& series,
                                        const std::vector<const Oracle*>& references = {},
                                        const Granted& granted = {}) {
  StatedTolerance tolerance = granted.tolerance;
  if (tolerance.by.empty()) tolerance.by = "the test";
  const std::string complaint =
      tolerance.IsZero()
          ? ComplaintAbout(subject, series, references)
          : ComplaintAbout(*WithTolerance(subject, tolerance), series, references);
  if (complaint.empty()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << complaint;
}

}  // namespace touchstone
