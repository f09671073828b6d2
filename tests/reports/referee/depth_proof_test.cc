// Tests of what the proof of a depth must refuse.

#include <cmath>

#include <gtest/gtest.h>

#include "reports/referee/inner_polytope.h"
#include "tests/reports/referee/awkward_scene.h"

namespace touchstone::referee {
namespace {

class DepthProofTest : public testing::Test {
 protected:
  DepthProof Prove() const { return CertifyDepth<Precise>(M, polytope, target); }
  Facet<double>& AnyFacet() {
    for (Facet<double>& f : polytope.facets) {
      if (!f.removed) return f;
    }
    return polytope.facets.front();
  }

  // A cylinder of radius 0.4 whose end overlaps a hull with its apex 0.1 below the
  // middle.
  Body A = Place(Cylinder{0.4, 0.5}, {0, 0, 0});
  Body B = Place(ConvexHull{{{0, 0, 0}, {1, 0.1, 1}, {-0.9, 0.8, 1.1}, {0.1, -1, 0.9}}},
                 {0.02, 0.01, 0.4});
  MinkowskiDifference M{A, B};
  double target = 0x1p-48;
  InnerPolytope<double> polytope = Expand(M, FindNearest<double>(M, {}), target, 500);
};

TEST_F(DepthProofTest, IsTightForWhatTheSearchFound) {
  const DepthProof proof = Prove();
  EXPECT_NEAR(proof.depth.lo, 0.1,
              1e-14);  // The tolerance is some ten roundings of a scene of size 2.
  EXPECT_NEAR(proof.depth.hi, 0.1, 1e-14);
}

TEST_F(DepthProofTest, ClaimsNothingForASurfaceWithAHole) {
  AnyFacet().removed = true;
  EXPECT_EQ(Prove().depth.lo, 0);
}

TEST_F(DepthProofTest, ClaimsNothingForAFacetInsideOut) {
  std::swap(AnyFacet().corners[0], AnyFacet().corners[1]);
  EXPECT_EQ(Prove().depth.lo, 0);
}

TEST_F(DepthProofTest, ClaimsNothingForASurfaceThatDoesNotSurroundTheOrigin) {
  for (DifferencePoint<double>& point : polytope.vertices) {
    // With B reduced to its apex and A to its far end, the differences lie in a disc that
    // does not surround the origin.
    point.q_B = {0, 0, 0};
    point.q_A = {point.q_A.x, point.q_A.y, -0.5};
  }
  EXPECT_EQ(Prove().depth.lo, 0);
}

TEST_F(DepthProofTest, DoesNotTrustThePlanesThatTheSearchRemembers) {
  for (Facet<double>& f : polytope.facets) f.distance += 1;
  EXPECT_LE(Prove().depth.lo, 0.1 + 1e-14);
  for (Facet<double>& f : polytope.facets) f.n = {-f.n.x, f.n.y, f.n.z};
  EXPECT_LE(Prove().depth.lo, 0.1 + 1e-14);
}

TEST_F(DepthProofTest, DoesNotTrustTheDirectionThatTheSearchRemembers) {
  polytope.n = {1, 0, 0};
  polytope.overlap = 0;
  EXPECT_GE(Prove().depth.hi, 0.1 - 1e-14);
}

}  // namespace
}  // namespace touchstone::referee
