#include "reports/contacts/checks/separation_error.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reports/contacts/checks/found_by.h"
#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

ContactTruth Truth(double lo, double hi) {
  ContactTruth truth;
  truth.separation = {lo, hi};
  return truth;
}

TEST(SeparationError, OfAHalvedDepthIsHalfTheDepth) {
  EXPECT_DOUBLE_EQ(SeparationError(Truth(-0.02, -0.02), -0.01), 0.01);
}

TEST(SeparationError, OfASwappedSignIsTwiceTheDepth) {
  EXPECT_DOUBLE_EQ(SeparationError(Truth(-0.02, -0.02), 0.02), 0.04);
}

TEST(SeparationError, IsNoneAnywhereInsideTheEnclosure) {
  for (const double separation : {-0.03, -0.021, -0.01}) {
    EXPECT_EQ(SeparationError(Truth(-0.03, -0.01), separation), 0);
  }
}

TEST(SeparationError, CountsFromTheNearerEndOfTheEnclosure) {
  // A difference of numbers near 0.035 is off by at most half their last bits, 2^-57.
  EXPECT_NEAR(SeparationError(Truth(-0.03, -0.01), -0.035), 0.005, 0x1p-57);
  EXPECT_EQ(SeparationError(Truth(-0.03, -0.01), 0.0), 0.01);
}

TEST(SeparationError, OfNanIsNanWhichNoToleranceAdmits) {
  EXPECT_TRUE(std::isnan(SeparationError(Truth(-0.03, -0.01), NAN)));
}

/** Returns the proof against the right answer with another separation [m]. */
Proof ProofAgainst(const Specimen& specimen, double separation) {
  ContactAnswer answer = specimen.right;
  answer.separation = separation;
  return *FoundBy(CheckSeparation, specimen, answer).evidence;
}

// The box of the specimen touches the sphere on its face, 0.01 m deep.
TEST(CheckSeparation, ComparesTwoDepthsAndNotADepthWithAGap) {
  const Specimen s = SphereInBoxFace(0.01);
  const Proof deeper = ProofAgainst(s, -0.03);
  EXPECT_EQ(deeper.kind, ProofKind::kTranslation);
  EXPECT_EQ(deeper.n_W, s.truth.certificate.n_AB_W);
  EXPECT_THAT(InWords(deeper, "mine"),
              testing::AllOf(testing::StartsWith("mine says 0.03 m deep; moving B by "),
                             testing::EndsWith(" separates them, 0.02 m less.")));
  const Proof apart = ProofAgainst(s, 0.02);
  EXPECT_EQ(apart.kind, ProofKind::kNoTranslation);
  EXPECT_THAT(InWords(apart, "mine"),
              testing::AllOf(testing::StartsWith("mine says 0.02 m apart; no translation "
                                                 "shorter than 0.01"),
                             testing::EndsWith(" m separates them.")));
}

TEST(CheckSeparation, ShowsWhatIsLeftOfTheOverlapAlongTheNormalOfTheAnswer) {
  const Specimen s = SphereInBoxFace(0.01);
  const Proof proof = ProofAgainst(s, -0.004);
  EXPECT_EQ(proof.claimed_W, *s.right.n_AB_W);
  EXPECT_NEAR(proof.rest, 0.006, 1e-9);
  EXPECT_THAT(InWords(proof, "mine"), testing::HasSubstr("leaves an overlap of 0.006"));
}

}  // namespace
}  // namespace touchstone
