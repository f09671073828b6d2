#include "reports/contacts/proof.h"

#include <array>
#include <cstdio>

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
  const std::string oracle = "mine";
  const std::string proof = ProveTouching({oracle, s.query, s.truth, s.right});
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
