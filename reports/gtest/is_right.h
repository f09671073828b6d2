#pragma once

#include <vector>

#include <gtest/gtest.h>

#include "reports/sweep/sweep.h"

namespace touchstone {

/** Returns whether `subject` answers every question of the series within the derived
 tolerance of the certified truth. A failure shows the first question as a file, the
 answers of `subject` and `references` side by side, the proofs, and how to ask again:

     EXPECT_TRUE(IsRight(*mine, {.A = ShapeKind::kBox, .B = ShapeKind::kBox}, {fcl}));

 A reference that is wrong is shown so, and is not held against the subject. */
inline testing::AssertionResult IsRight(
    const Oracle& subject, const QuestionSeries& series,
    const std::vector<const Oracle*>& references = {}) {
  const std::string complaint = ComplaintAbout(subject, series, references);
  if (complaint.empty()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << complaint;
}

}  // namespace touchstone
