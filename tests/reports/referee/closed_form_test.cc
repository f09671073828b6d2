// Cases with a truth that can be derived by hand, at poses where nothing is exact in
// binary.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "reports/referee/referee.h"
#include "tests/reports/referee/awkward_scene.h"

namespace touchstone {
namespace {

/** Expects the separation derived by hand. Placing the bodies rounds the poses, which
 moves the truth by at most the band of the input. The enclosure itself is a few ulps of
 the scene. */
void ExpectSeparation(const ContactQuery& query, double expected) {
  const ContactTruth truth = ComputeContactTruth(query);
  const double ulp = std::numeric_limits<double>::epsilon() * SceneSize(query);
  EXPECT_LE(truth.separation.lo, truth.separation.hi);
  EXPECT_LE(truth.separation.hi - truth.separation.lo, 16 * ulp);
  EXPECT_NEAR(truth.separation.lo, expected, truth.input_rounding + 16 * ulp);
  EXPECT_NEAR(truth.separation.hi, expected, truth.input_rounding + 16 * ulp);
  // Swapping the bodies asks the same question.
  const ContactTruth swapped = ComputeContactTruth({query.B, query.A});
  EXPECT_NEAR(swapped.separation.lo, truth.separation.lo, 16 * ulp);
  // The certificate's own direction bounds the separation from below.
  const Enclosure overlap = Overlap(query, truth.certificate.n_AB_W);
  EXPECT_NEAR(-overlap.hi, truth.separation.lo, 16 * ulp);
}

TEST(ClosedForm, SpheresAreApartByTheirCentresLessTheirRadii) {
  const Eigen::Vector3d p(0.3, 0.4, 1.2);  // |p| = 1.3
  ExpectSeparation({Place(Sphere{0.7}, {0, 0, 0}), Place(Sphere{0.11}, p)}, 1.3 - 0.81);
  ExpectSeparation({Place(Sphere{0.7}, {0, 0, 0}), Place(Sphere{0.9}, p)}, 1.3 - 1.6);
}

TEST(ClosedForm, ConcentricSpheresAreAsDeepAsTheirRadiiTogether) {
  ExpectSeparation(
      {Place(Sphere{0.7}, {0.1, 0.2, 0.3}), Place(Sphere{0.2}, {0.1, 0.2, 0.3})}, -0.9);
}

TEST(ClosedForm, SphereInABoxLeavesThroughTheNearestFace) {
  const Body box = Place(Box{{0.3, 0.2, 0.1}}, {0, 0, 0});
  ExpectSeparation({box, Place(Sphere{1.0 / 3}, {0.07, -0.03, 0.04})}, -(0.06 + 1.0 / 3));
}

TEST(ClosedForm, SphereOffABoxCornerIsApartByThePythagoreanDistance) {
  const Body box = Place(Box{{0.3, 0.2, 0.1}}, {0, 0, 0});
  // 0.1 * (1, 2, 2) off the corner: 0.3 away.
  ExpectSeparation({box, Place(Sphere{0.05}, {0.4, 0.4, 0.3})}, 0.25);
}

// The axes cross at a right angle, 0.5 apart along the third.
TEST(ClosedForm, CrossedCapsulesAreApartAlongTheCommonPerpendicular) {
  const Body A = Place(Capsule{0.2, 0.7}, {0, 0, 0});
  const Eigen::Quaterniond along_x = Turn(M_PI / 2, Eigen::Vector3d::UnitY());
  ExpectSeparation({A, Place(Capsule{0.1, 0.4}, {0.05, 0.5, 0.1}, along_x)}, 0.2);
  ExpectSeparation({A, Place(Capsule{0.4, 0.4}, {0.05, 0.5, 0.1}, along_x)}, -0.1);
}

// Both axes cross at one point: the cores touch, and the depth is the sum of the radii.
TEST(ClosedForm, CapsulesWithCrossingAxesAreAsDeepAsTheirRadiiTogether) {
  const Body A = Place(Capsule{0.2, 0.7}, {0, 0, 0});
  const Eigen::Quaterniond along_x = Turn(M_PI / 2, Eigen::Vector3d::UnitY());
  ExpectSeparation({A, Place(Capsule{0.1, 0.4}, {0.1, 0, 0.2}, along_x)}, -0.3);
}

// Both axes lie in the plane y = 0, exactly: the origin is in the plane of the flat
// difference of the axes, and may be inside or outside it.
TEST(ClosedForm, CapsulesWithAxesInOnePlaneAreJudgedWithinIt) {
  Eigen::Matrix3d along_x;
  along_x << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  const Body A{Capsule{0.25, 0.75}, Pose{}};
  const auto B = [&](double x, double z) {
    return Body{Capsule{0.125, 0.5}, Pose::FromMatrix({x, 0, z}, along_x)};
  };
  ExpectSeparation({A, B(0.25, 0.5)}, -0.375);
  ExpectSeparation({A, B(1.25, 0.5)}, 0.75 - 0.375);
  ExpectSeparation({A, B(0.25, 1.5)}, 0.75 - 0.375);
  // The end of B's axis is 0.75 to the side of the end of A's, and 1 above it.
  ExpectSeparation({A, B(1.25, 1.75)}, 1.25 - 0.375);
}

TEST(ClosedForm, CollinearCapsulesAreApartEndToEnd) {
  const Body A = Place(Capsule{0.2, 0.7}, {0, 0, 0});
  ExpectSeparation({A, Place(Capsule{0.1, 0.4}, {0, 0, 1.5})}, 1.5 - 1.1 - 0.3);
  ExpectSeparation({A, Place(Capsule{0.1, 0.4}, {0, 0, 0.6})}, -0.3);
}

// B is turned by 45 degrees about z, so that its edge reaches √2 h towards A.
TEST(ClosedForm, BoxEdgeOnFaceIsAsDeepAsItsDiagonalSays) {
  const Body A = Place(Box{{0.5, 0.6, 0.7}}, {0, 0, 0});
  const Eigen::Quaterniond turned = Turn(M_PI / 4, Eigen::Vector3d::UnitZ());
  const double reach = std::sqrt(2.0) * 0.1;
  ExpectSeparation(
      {A, Place(Box{{0.1, 0.1, 0.2}}, {0.5 + reach - 0.01, 0.1, 0.2}, turned)}, -0.01);
  ExpectSeparation(
      {A, Place(Box{{0.1, 0.1, 0.2}}, {0.5 + reach + 0.01, 0.1, 0.2}, turned)}, 0.01);
}

// Two cubes turned by 45 degrees about crossed axes meet edge on edge, along z.
TEST(ClosedForm, CrossedBoxEdgesAreAsDeepAsBothDiagonalsSay) {
  const double reach = std::sqrt(2.0) * 0.3;
  const Body A =
      Place(Box{{0.3, 0.3, 0.3}}, {0, 0, 0}, Turn(M_PI / 4, Eigen::Vector3d::UnitX()));
  for (const double gap : {-0.02, 0.02}) {
    ExpectSeparation({A, Place(Box{{0.3, 0.3, 0.3}}, {0.05, 0.02, 2 * reach + gap},
                               Turn(M_PI / 4, Eigen::Vector3d::UnitY()))},
                     gap);
  }
}

TEST(ClosedForm, BoxesOfOneOrientationAreDeepAlongTheirLeastOverlap) {
  ExpectSeparation({Place(Box{{0.5, 0.6, 0.7}}, {0, 0, 0}),
                    Place(Box{{0.1, 0.2, 0.3}}, {0.5, 0.7, -0.2})},
                   -0.1);
}

TEST(ClosedForm, CapsuleLyingInABoxFaceIsDeepByItsRadius) {
  const Eigen::Quaterniond along_x = Turn(M_PI / 2, Eigen::Vector3d::UnitY());
  ExpectSeparation({Place(Box{{0.5, 0.6, 0.3}}, {0, 0, 0}),
                    Place(Capsule{0.1, 0.2}, {0.03, -0.04, 0.35}, along_x)},
                   -0.05);
}

TEST(ClosedForm, HalfSpaceIsDeepToTheLowestPointOfEveryShape) {
  const Body ground = Place(HalfSpace{}, {0.4, -0.3, 0.1});
  const double tilt = 0.4;
  const Eigen::Quaterniond q =
      Turn(tilt, {1, 2, 0});  // The body's z is at the angle `tilt` to the up direction.
  const double c = std::cos(tilt);
  const double s = std::sin(tilt);
  const Eigen::Vector3d p(2.3, 1.9, 0.6);  // 0.5 above the plane.
  ExpectSeparation({ground, Place(Sphere{0.7}, p, q)}, 0.5 - 0.7);
  ExpectSeparation({ground, Place(Capsule{0.2, 0.6}, p, q)}, 0.5 - 0.6 * c - 0.2);
  ExpectSeparation({ground, Place(Cylinder{0.2, 0.6}, p, q)}, 0.5 - 0.6 * c - 0.2 * s);
  ExpectSeparation({ground, Place(Cone{0.2, 0.6}, p, q)}, 0.5 - 0.6 * c - 0.2 * s);
  ExpectSeparation({Place(Cone{0.2, 0.6}, p, Turn(M_PI - tilt, {1, 2, 0})), ground},
                   0.5 - 0.6 * c);
  // The up direction in the body frame is sin(tilt) (-2, 1, 0)/√5 + cos(tilt) z, up to
  // the sign of the first term.
  const double up_x = s * 2 / std::sqrt(5.0);
  const double up_y = s / std::sqrt(5.0);
  ExpectSeparation({ground, Place(Box{{0.2, 0.3, 0.4}}, p, q)},
                   0.5 - (0.2 * up_x + 0.3 * up_y + 0.4 * c));
  const ConvexHull hull{{{0, 0, -0.9}, {0, 0, 0.3}, {0.1, 0, 0}, {0, 0.1, 0}}};
  ExpectSeparation({ground, Place(hull, p, q)}, 0.5 - 0.9 * c);
}

}  // namespace
}  // namespace touchstone
