#include "reports/contacts/checks/touching.h"

#include <array>
#include <cstdio>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "tests/reports/contacts/checks/found_by.h"
#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

/** Returns the vector written as `words`. */
Eigen::Vector3d Read(const std::string& words) {
  std::array<double, 3> v{};
  EXPECT_EQ(std::sscanf(words.c_str(), "(%lf, %lf, %lf)", &v[0], &v[1], &v[2]), 3);
  return {v[0], v[1], v[2]};
}

TEST(TouchingError, IsOneForAMissedContact) {
  Specimen specimen = SphereInBoxFace(2e-3);
  EXPECT_EQ(TouchingError(specimen.truth, specimen.right), 0);
  specimen.right.touching = false;
  EXPECT_EQ(TouchingError(specimen.truth, specimen.right), 1);
}

TEST(TouchingError, IsOneForAPhantomContact) {
  Specimen specimen = SphereInBoxFace(-2e-3);
  EXPECT_EQ(TouchingError(specimen.truth, specimen.right), 0);
  specimen.right.touching = true;
  EXPECT_EQ(TouchingError(specimen.truth, specimen.right), 1);
}

TEST(TouchingError, IsZeroForAnUndecidedTruth) {
  Specimen specimen = SphereInBoxFace(0);
  specimen.truth.touching = Touching::kUndecided;
  for (const bool touching : {false, true}) {
    specimen.right.touching = touching;
    EXPECT_EQ(TouchingError(specimen.truth, specimen.right), 0);
  }
}

// The corners of a box have n·x between n·p ± Σ |n·e_i| h_i.
TEST(CheckTouching, PrintsAPlaneThatSeparatesExactlyAsPrinted) {
  Specimen s = SphereInBoxFace(-1e-9);
  s.right.touching = true;
  const std::string proof = FoundBy(CheckTouching, s, s.right).proof;
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

}  // namespace
}  // namespace touchstone
