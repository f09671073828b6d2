#include "reports/contacts/proof.h"

#include <array>
#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/text/format_vector.h"
#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

/** Returns the vector written as `words`. */
Eigen::Vector3d Read(const std::string& words) {
  std::array<double, 3> v{};
  EXPECT_EQ(std::sscanf(words.c_str(), "(%lf, %lf, %lf)", &v[0], &v[1], &v[2]), 3);
  return {v[0], v[1], v[2]};
}

// The corners of a box have n·x between n·p ± Σ |n·e_i| h_i.
TEST(ProveTouching, PrintsAPlaneThatSeparatesExactlyAsPrinted) {
  Specimen s = SphereInBoxFace(-1e-9);
  s.right.touching = true;
  const std::string proof = InWords(ProveTouching({s.query, s.truth, s.right}), "mine");
  const std::size_t plane = proof.find("n·x = ");
  ASSERT_NE(plane, std::string::npos) << proof;
  const double c = std::stod(proof.substr(plane + std::string("n·x = ").size()));
  const Eigen::Vector3d n = Read(proof.substr(proof.find('(')));
  const Eigen::Vector3d& h = std::get<Box>(s.query.A.shape).half_extents;
  const Pose& X_WA = s.query.A.X_WB;
  EXPECT_LT(n.dot(X_WA.p_WB) + (X_WA.R_WB.transpose() * n).cwiseAbs().dot(h), c);
  const double r = std::get<Sphere>(s.query.B.shape).radius;
  EXPECT_GT(n.dot(s.query.B.X_WB.p_WB) - n.norm() * r, c);
}

// The box of the specimen touches the sphere on its face, 0.01 m deep.
TEST(ProveSeparation, ComparesTwoDepthsAndNotADepthWithAGap) {
  const Specimen s = SphereInBoxFace(0.01);
  const Proof deeper = ProveSeparation({s.query, s.truth, s.right}, -0.03);
  EXPECT_EQ(deeper.kind, ProofKind::kTranslation);
  EXPECT_EQ(deeper.n_W, s.truth.certificate.n_AB_W);
  EXPECT_THAT(InWords(deeper, "mine"),
              testing::AllOf(testing::StartsWith("mine says 0.03 m deep; moving B by "),
                             testing::EndsWith(" separates them, 0.02 m less.")));
  const Proof apart = ProveSeparation({s.query, s.truth, s.right}, 0.02);
  EXPECT_EQ(apart.kind, ProofKind::kNoTranslation);
  EXPECT_THAT(InWords(apart, "mine"),
              testing::AllOf(testing::StartsWith("mine says 0.02 m apart; no translation "
                                                 "shorter than 0.01"),
                             testing::EndsWith(" m separates them.")));
}

TEST(ProveSeparation, ShowsWhatIsLeftOfTheOverlapAlongTheNormalOfTheAnswer) {
  const Specimen s = SphereInBoxFace(0.01);
  const Proof proof = ProveSeparation({s.query, s.truth, s.right}, -0.004);
  EXPECT_EQ(proof.claimed_W, *s.right.n_AB_W);
  EXPECT_NEAR(proof.rest, 0.006, 1e-9);
  EXPECT_THAT(InWords(proof, "mine"), testing::HasSubstr("leaves an overlap of 0.006"));
}

// Exactly touching: the depth to compare with is 0, and no sign tells it from a gap.
TEST(InWords, ComparesADepthWithTheDepthOfBodiesThatJustTouch) {
  const Proof proof{.kind = ProofKind::kTranslation,
                    .claim = ProofClaim::kSeparation,
                    .said = -0.5,
                    .bound = 0,
                    .n_W = {0, 0, 1}};
  EXPECT_EQ(InWords(proof, "mine"),
            "mine says 0.5 m deep; moving B by 0 m along (0, 0, 1) separates them, 0.5 m "
            "less.");
}

}  // namespace
}  // namespace touchstone
