#include "reports/writers/explanation_writer.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hand_made_report.h"

namespace touchstone {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string Explained(const RunReport& report, const ExplanationStyle& style = {}) {
  std::ostringstream out;
  WriteExplanation(report, style, out);
  return out.str();
}

TEST(WriteExplanation, NamesTheOraclesThatAreRightAndWrong) {
  const std::string text = Explained(HandMadeReport());
  // deep: mine passes; theirs is a known discrepancy, which also counts as wrong.
  EXPECT_THAT(text, HasSubstr("Right: mine\nWrong: theirs/float"));
  // wrong: mine is proved wrong, theirs is NaN.
  EXPECT_THAT(text, HasSubstr("Right: none\nWrong: mine, theirs/float"));
  // grazing: undecidable and unsupported are neither.
  EXPECT_THAT(text, HasSubstr("Right: none\nWrong: none"));
}

TEST(WriteExplanation, WritesEachLedgerReasonOncePerOracle) {
  RunReport report = HandMadeReport();
  // deep: theirs/float is known in a second measure, for the same reason.
  Finding second = report.findings[1];
  second.measure = MeasureKind::kExcess;
  report.findings.insert(report.findings.begin() + 2, second);
  const std::string text = Explained(report);
  const std::string reason = "Ledger entry for theirs/float (precision): Float build";
  const std::size_t first = text.find(reason);
  EXPECT_NE(first, std::string::npos);
  EXPECT_EQ(text.find(reason, first + 1), std::string::npos);
}

TEST(WriteExplanation, WritesEqualFindingsOfTwoOraclesOnce) {
  RunReport report = HandMadeReport();
  // wrong: theirs/float answers the same as mine.
  report.scenarios[1].answers[1] = report.scenarios[1].answers[0];
  report.findings[2].proof = "mine says 0.04 deep, which is not so";
  Finding same = report.findings[2];
  same.oracle = "theirs/float";
  same.proof = "theirs/float says 0.04 deep, which is not so";
  report.findings.erase(report.findings.begin() + 3, report.findings.begin() + 5);
  report.findings.insert(report.findings.begin() + 3, same);
  const std::string text = Explained(report);
  EXPECT_THAT(text, HasSubstr("Proof: mine says 0.04 deep"));
  EXPECT_THAT(text, Not(HasSubstr("Proof: theirs/float says")));
  EXPECT_THAT(text, HasSubstr("    likewise theirs/float\n"));
  EXPECT_THAT(Explained(report, {.everything = true}),
              HasSubstr("contact                -0.04 at ("));
}

TEST(WriteExplanation, WritesTheSimplestProofAndNamesTheOtherMeasures) {
  const RunReport report = HandMadeReport();
  const std::string also = "    also: consistency_error 1e+12 × tolerance\n";
  EXPECT_THAT(Explained(report), HasSubstr(also));
  const std::string everything = Explained(report, {.everything = true});
  EXPECT_THAT(everything, Not(HasSubstr(also)));
  EXPECT_THAT(everything, HasSubstr("mine: fail in consistency_error"));
}

TEST(WriteExplanationTable, WritesOneLinePerScenario) {
  std::ostringstream out;
  WriteExplanationTable(HandMadeReport(), out);
  EXPECT_EQ(out.str(),
            "scenario                   truth        separation [m]  mine        right  "
            "wrong\n"
            "contact/box_sphere/deep    touching              -0.05  pass            1  "
            "theirs/float\n"
            "contact/box_sphere/wrong   touching              -0.05  fail            0  "
            "mine, theirs/float (unusable)\n"
            "contact/cone_cone/grazing  undecided             -0.05  undecidable     0  "
            "none\n");
}

TEST(WriteExplanation, WritesTruthProofAndLedgerReason) {
  const std::string text = Explained(HandMadeReport());
  EXPECT_THAT(text, HasSubstr("Touching: the separation is -0.05 m, certified"));
  EXPECT_THAT(text, HasSubstr("moving B by 0.04 along n leaves 0.01 of overlap"));
  EXPECT_THAT(text, HasSubstr("Ledger entry for theirs/float (precision): Float build"));
}

}  // namespace
}  // namespace touchstone
