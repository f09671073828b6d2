#include "reports/finding/ending.h"

#include <gtest/gtest.h>

namespace touchstone {
namespace {

Finding Ending(Verdict verdict, const std::string& proof) {
  Finding finding;
  finding.oracle = "fcl/signed_distance";
  finding.verdict = verdict;
  finding.proof = proof;
  return finding;
}

TEST(KindOfProof, IsTheProofWithoutItsNumbers) {
  EXPECT_EQ(KindOfProof("says 0.5 m deep along (1, -2e-05, 3)"),
            KindOfProof("says 17 m deep along (0, 0.25, -1)"));
  EXPECT_EQ(KindOfProof("at 0x7ffd10"), KindOfProof("at 0x55aa"));
  EXPECT_NE(KindOfProof("says 0.5 m deep"), KindOfProof("says 0.5 m apart"));
}

TEST(KindOfProof, KeepsLinesOfTheSource) {
  EXPECT_EQ(KindOfProof("aborted: gjk.h:1234: Assertion `x > 0.5' failed"),
            "aborted: gjk.h:1234: Assertion `x > #' failed");
  EXPECT_NE(KindOfProof("aborted: gjk.h:12: x"), KindOfProof("aborted: gjk.h:13: x"));
  EXPECT_EQ(KindOfProof("separation:12.5"), KindOfProof("separation:13.25"));
}

TEST(EndingInWords, KeepsTheNumbers) {
  EXPECT_EQ(EndingInWords(Ending(Verdict::kTimedOut,
                                 "fcl/signed_distance: no answer after 2.01 s")),
            "no answer after 2.01 s");
  EXPECT_EQ(EndingInWords(Ending(Verdict::kFail, "fcl/signed_distance says 1 m")), "");
}

TEST(EndingOf, IsEmptyForAnAnswer) {
  EXPECT_EQ(EndingOf(Ending(Verdict::kFail, "fcl/signed_distance says 1 m")), "");
  EXPECT_EQ(EndingOf(Ending(Verdict::kPass, "")), "");
}

TEST(EndingOf, DoesNotNameTheOracle) {
  EXPECT_EQ(
      EndingOf(Ending(Verdict::kCrashed, "fcl/signed_distance: killed by SIGSEGV.")),
      "killed by SIGSEGV.");
  EXPECT_EQ(
      EndingOf(Ending(Verdict::kTimedOut, "fcl/signed_distance: no answer after 2.01 s")),
      "no answer after # s");
  EXPECT_EQ(EndingOf(Ending(Verdict::kInvalid, "no normal in 2 contacts")),
            "no normal in # contacts");
}

}  // namespace
}  // namespace touchstone
