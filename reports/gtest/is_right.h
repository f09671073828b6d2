#pragma once

#include <vector>

#include <gtest/gtest.h>

#include "reports/sweep/sweep.h"

namespace touchstone {

/** Returns whether `subject` answers every question of the series within the derived
 tolerance of the certified truth. A failure shows the first wrong question as a file, the
 answers of `subject` and `references` side by side, the proofs, and the command that
 repeats it:
      EXPECT_TRUE(IsRight(*mine, {.A = ShapeKind::kBox, .B = ShapeKind::kBox}, {fcl}));
 A wrong reference is shown as wrong, and does not make the subject fail. */
inline testing::AssertionResult IsRight(
    const Oracle& subject, const QuestionSeries& series,
    const std::vector<const Oracle*>& references = {}) {
  const std::string complaint = ComplaintAbout(subject, series, references);
  if (complaint.empty()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << complaint;
}

}  // namespace touchstone
