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

TEST(WriteExplanation, GivesAReasonOfTheLedgerOnceForAnOracle) {
  RunReport report = HandMadeReport();
  // deep: theirs/float is known in a second measure, excused by the same reason.
  Finding second = report.findings[1];
  second.measure = MeasureKind::kExcess;
  report.findings.insert(report.findings.begin() + 2, second);
  std::ostringstream out;
  WriteExplanation(report, out);
  const std::string reason = "Ledger, of theirs/float: Float build";
  const std::size_t first = out.str().find(reason);
  EXPECT_NE(first, std::string::npos);
  EXPECT_EQ(out.str().find(reason, first + 1), std::string::npos);
}

TEST(WriteExplanationTable, GivesALineAScenario) {
  std::ostringstream out;
  WriteExplanationTable(HandMadeReport(), out);
  EXPECT_EQ(out.str(),
            "scenario                   truth        separation [m]  mine        right  "
            "wrong\n"
            "contact/box_sphere/deep    touching              -0.05  pass            1  "
            "theirs/float\n"
            "contact/box_sphere/wrong   touching              -0.05  fail            0  "
            "mine, theirs/float\n"
            "contact/cone_cone/grazing  undecided             -0.05  undecidable     0  "
            "nobody\n");
}

TEST(WriteExplanation, GivesTruthProofAndTheReasonOfTheLedger) {
  std::ostringstream out;
  WriteExplanation(HandMadeReport(), out);
  EXPECT_THAT(out.str(), HasSubstr("the separation lies in [-0.05, -0.05] m"));
  EXPECT_THAT(out.str(), HasSubstr("moving B by 0.04 along n leaves 0.01 of overlap"));
  EXPECT_THAT(out.str(), HasSubstr("Ledger, of theirs/float: Float build"));
}

}  // namespace
}  // namespace touchstone
