#include "reports/writers/explanation_writer.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hand_made_report.h"

namespace touchstone {
namespace {

using ::testing::HasSubstr;

TEST(WriteExplanation, NamesWhoIsRightAndWhoIsWrong) {
  std::ostringstream out;
  WriteExplanation(HandMadeReport(), out);
  // deep: mine passes, theirs is a known discrepancy, which is wrong all the same.
  EXPECT_THAT(out.str(), HasSubstr("Right: mine\nWrong: theirs/float"));
  // wrong: mine is proved wrong, theirs is NaN.
  EXPECT_THAT(out.str(), HasSubstr("Right: nobody\nWrong: mine, theirs/float"));
  // grazing: undecidable and unsupported are neither.
  EXPECT_THAT(out.str(), HasSubstr("Right: nobody\nWrong: nobody"));
}

TEST(WriteExplanation, GivesTruthProofAndTheReasonOfTheLedger) {
  std::ostringstream out;
  WriteExplanation(HandMadeReport(), out);
  EXPECT_THAT(out.str(), HasSubstr("the separation lies in [-0.05, -0.05] m"));
  EXPECT_THAT(out.str(), HasSubstr("moving B by 0.04 along n leaves 0.01 of overlap"));
  EXPECT_THAT(out.str(), HasSubstr("Ledger: Float build"));
}

}  // namespace
}  // namespace touchstone
