// Tests of cylinders and cones, for which there is no exact kernel: the bounds have to
// meet, no direction may contradict them, and a blind search has to come as near as it
// can.

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "reports/referee/referee.h"
#include "tests/reports/referee/awkward_scene.h"
#include "tests/reports/referee/independent_search.h"
#include "tests/reports/referee/random_scene.h"

namespace touchstone {
namespace {

Shape SomeShape(RandomScene& random, int kind) {
  const double a = random.Uniform(0.1, 1);
  const double b = random.Uniform(0.1, 1);
  switch (kind) {
    case 0:
      return Cylinder{a, b};
    case 1:
      return Cone{a, b};
    case 2:
      return random.SomeBox(1);
    case 3:
      return Capsule{a, b};
    case 4:
      return Sphere{a};
    default:
      return random.SomeHull(1, 12);
  }
}

TEST(CurvedPairs, AreBoundedTightlyAndNoDirectionContradictsThem) {
  RandomScene random(20);
  int touching = 0;
  for (int i = 0; i < 120; ++i) {
    const Shape A = SomeShape(random, i % 2);
    const Shape B = SomeShape(random, i / 2 % 6);
    const Eigen::Vector3d p = random.Point(1);
    const Body placed_A{A, Pose::FromQuaternion(p, random.Rotation())};
    const ContactQuery query{
        placed_A, {B, Pose::FromQuaternion(p + random.Point(1.5), random.Rotation())}};
    const ContactTruth truth = ComputeContactTruth(query);
    const Enclosure separation = truth.separation;
    const double ulp = std::numeric_limits<double>::epsilon() * SceneSize(query);
    EXPECT_LE(separation.hi - separation.lo, 64 * ulp) << "pair " << i;
    // Upper bound: no direction that the search tries separates them further.
    EXPECT_LE(-LeastOverlapFound(query), separation.hi + ulp) << "pair " << i;
    // Lower bound: its own direction proves it, to the rounding of that direction.
    EXPECT_NEAR(-OverlapFound(query, truth.certificate.n_AB_W), separation.lo, 64 * ulp)
        << "pair " << i;
    touching += separation.hi < 0;
  }
  EXPECT_GT(touching, 30);
  EXPECT_LT(touching, 100);
}

void ExpectSeparation(const ContactQuery& query, double expected) {
  const ContactTruth truth = ComputeContactTruth(query);
  const double ulp = std::numeric_limits<double>::epsilon() * SceneSize(query);
  EXPECT_LE(truth.separation.hi - truth.separation.lo, 64 * ulp);
  EXPECT_NEAR(truth.separation.lo, expected, truth.input_rounding + 64 * ulp);
  EXPECT_NEAR(truth.separation.hi, expected, truth.input_rounding + 64 * ulp);
}

TEST(CurvedPairs, CylinderStandingInAnotherIsDeepAlongTheirCommonAxis) {
  ExpectSeparation(
      {Place(Cylinder{0.4, 0.5}, {0, 0, 0}), Place(Cylinder{0.3, 0.2}, {0.1, 0, 0.69})},
      -0.01);
}

// The least overlap, 0.3 + 0.2, is reached all around the axis; along the axis it is 1 +
// 1.
TEST(CurvedPairs, CoaxialCylindersAreAsDeepAsTheirRadiiTogether) {
  ExpectSeparation(
      {Place(Cylinder{0.3, 1}, {0, 0, 0}), Place(Cylinder{0.2, 1}, {0, 0, 0})}, -0.5);
}

TEST(CurvedPairs, ParallelCylindersSideBySideAreDeepAlongTheLineOfCentres) {
  ExpectSeparation(
      {Place(Cylinder{0.3, 1}, {0, 0, 0}), Place(Cylinder{0.2, 0.7}, {0.3, 0.36, 0.1})},
      std::hypot(0.3, 0.36) - 0.5);
}

// Each cylinder contains a ball of its radius, and lies in a ball √2 times as large.
TEST(CurvedPairs, CylindersWhoseOverlapsOverflowAreDeepByAnUnknownAmount) {
  const Cylinder huge{1e160, 1e160};
  const ContactTruth truth = ComputeContactTruth(
      {Place(huge, {0, 0, 0}), Place(huge, {0, 0, 0}, Turn(1, {1, 2, 3}))});
  EXPECT_LE(truth.separation.lo, -2e160);
  EXPECT_GE(truth.separation.hi, -2e160 * std::sqrt(2));
}

// The rim of a tilted cylinder is r sin + h cos below its centre.
TEST(CurvedPairs, TiltedCylinderOnABoxIsDeepByItsRim) {
  const double tilt = 0.3;
  const double reach = 0.2 * std::sin(tilt) + 0.3 * std::cos(tilt);
  for (const double gap : {-0.01, 0.01}) {
    ExpectSeparation(
        {Place(Box{{2, 2, 0.5}}, {0, 0, 0}),
         Place(Cylinder{0.2, 0.3}, {0.1, 0.2, 0.5 + reach + gap}, Turn(tilt, {1, 3, 0}))},
        gap);
  }
}

// The centre of a cone is r h / √(r² + 4 h²) from its side, h from its base.
TEST(CurvedPairs, SphereOnTheAxisOfAConeLeavesThroughItsSideAllAround) {
  const double side = 0.3 * 0.5 / std::sqrt(0.3 * 0.3 + 4 * 0.5 * 0.5);
  ExpectSeparation({Place(Cone{0.3, 0.5}, {0, 0, 0}), Place(Sphere{0.1}, {0, 0, 0})},
                   -(side + 0.1));
}

TEST(CurvedPairs, PointIsAsFarFromARimAsPythagorasSays) {
  const Body cylinder = Place(Cylinder{0.3, 0.5}, {0, 0, 0});
  const Eigen::Vector3d p = AwkwardPose() * Eigen::Vector3d(0.6 * 0.6, 0.6 * 0.8, 0.9);
  const Enclosure e = SignedDistance(cylinder, p);
  EXPECT_NEAR(e.lo, 0.5, 1e-14);  // 0.3 out and 0.4 up, in a scene of size 2.
  EXPECT_NEAR(e.hi, 0.5, 1e-14);
}

TEST(CurvedPairs, PointOnTheSurfaceHasZeroDistance) {
  const Body cone = Place(Cone{0.3, 0.5}, {0, 0, 0});
  const Enclosure e =
      SignedDistance(cone, AwkwardPose() * Eigen::Vector3d(0.09, 0.12, 0));
  EXPECT_NEAR(e.lo, 0, 1e-14);
  EXPECT_NEAR(e.hi, 0, 1e-14);
}

// The search in double and the search in high precision each find one good bound here. A
// bound without its own direction would prove nothing: they are half a radian apart.
TEST(CurvedPairs, EachBoundKeepsTheDirectionThatProvesIt) {
  const Eigen::Matrix3d R_WB =
      (Eigen::Matrix3d() << -6.6613381477509392e-16, -1.1678616087278231e-15, 1,
       6.0712700190765511e-16, 1, 1.1678616087278235e-15, -1, 6.07127001907656e-16,
       -6.6613381477509392e-16)
          .finished();
  const ContactQuery query{
      {Box{{0.62208173494718433, 0.38730836094253329, 0.54666801797575199}},
       Pose::FromMatrix({0.78140318556777921, 0.52246110237155452, -0.67913916241127248},
                        Eigen::Matrix3d::Identity())},
      {Cone{0.60063157139169099, 0.62610782343066962},
       Pose::FromMatrix({0.78542927405126373, 1.5104010347057795, -0.67913916241127248},
                        R_WB)}};
  const ContactTruth truth = ComputeContactTruth(query);
  const double ulp = std::numeric_limits<double>::epsilon() * SceneSize(query);
  EXPECT_NEAR(-Overlap(query, truth.certificate.n_AB_W).hi, truth.separation.lo, ulp);
}

// GJK loses the normal here: the vector to the origin is as short as its own error.
TEST(CurvedPairs, ConeTouchingABoxEdgeIsKnownToRounding) {
  const ContactQuery query{
      {Cone{0.33752796105617888, 0.81887326105410996},
       Pose::FromQuaternion(
           {0.99546865162173748, -0.56747023424951326, 0.11096009747163516},
           {0.13147997780390255, -0.37167836633587292, -0.87937958489635126,
            0.26694522490972356})},
      {Box{{0.24440271364564825, 0.76494441963943205, 0.80642359652666662}},
       Pose::FromQuaternion(
           {1.4023662086448265, -0.28974896543351891, -0.21183406098469054},
           {-0.35899897446066764, 0.28172916263450859, 0.095788394843722008,
            0.88463156097366935})}};
  const Enclosure e = ComputeContactTruth(query).separation;
  EXPECT_LE(e.hi - e.lo, 1e-15);
}

TEST(CurvedPairs, NearTouchingAreKnownToATrillionthOfTheirSize) {
  RandomScene random(21);
  int narrow = 0;
  for (int i = 0; i < 600; ++i) {
    const Shape A = SomeShape(random, i % 2);
    const Shape B = SomeShape(random, i / 2 % 6);
    const Eigen::Vector3d p = random.Point(1);
    const Eigen::Quaterniond q = random.Rotation();
    ContactQuery query{{A, Pose::FromQuaternion(p, q)},
                       {B, Pose::FromQuaternion(p + random.Point(1.5), q)}};
    const ContactTruth truth = ComputeContactTruth(query);
    const double gap = random.Uniform(-1, 1) * random.Power(-17, -5);
    query.B.X_WB.p_WB += (gap - truth.separation.lo) * truth.certificate.n_AB_W;
    const Enclosure e = ComputeContactTruth(query).separation;
    EXPECT_LE(e.hi - e.lo, 1e-12 * SceneSize(query)) << "pair " << i;
    narrow += e.hi - e.lo <= 1e-17 * SceneSize(query);
  }
  // Only few are known to less than the rounding of their coordinates.
  EXPECT_LT(narrow, 300);
}

// A needle through a disc, both about one axis up to a rounding. The least overlap is the
// sum of the radii, nearly all around.
TEST(CurvedPairs, NearlyCoaxialCylindersAreAsDeepAsTheirRadiiTogether) {
  const Eigen::Matrix3d R_WB =
      (Eigen::Matrix3d() << -0.082967850105321261, 0.5425796420694472,
       -0.83589692418425088, 0.59276222241524212, -0.64740313016598461,
       -0.47906381070649434, -0.8010925561545581, -0.53523501292710218,
       -0.2679070686090248)
          .finished();
  const double r_A = 0.0059696417557210885;
  const double r_B = 0.2884463562315876;
  const ContactQuery query{
      {Cylinder{r_A, 1.0475631950174}, Pose::FromMatrix({0, 0, 0}, R_WB)},
      {Cylinder{r_B, 0.0031311989286406461},
       Pose::FromMatrix(0.125 * R_WB.col(2), R_WB)}};
  const ContactTruth truth = ComputeContactTruth(query);
  EXPECT_NEAR(truth.separation.lo, -(r_A + r_B), 1e-15);
  EXPECT_GE(truth.separation.hi, truth.separation.lo);
  EXPECT_LE(truth.separation.hi, truth.separation.lo + 1e-6);
  EXPECT_EQ(0 - Overlap(query, truth.certificate.n_AB_W).hi, truth.separation.lo);
}

Body Scaled(const Body& body, int exponent) {
  Body scaled = body;
  scaled.shape = Resized(body.shape, std::ldexp(1, exponent));
  scaled.X_WB.p_WB *= std::ldexp(1, exponent);
  return scaled;
}

// The promised range is from 1e-100 to 1e100 m.
TEST(Sizes, ScaleTheTruthExactlyOverThePromisedRange) {
  RandomScene random(22);
  for (int i = 0; i < 72; ++i) {
    const Shape A = SomeShape(random, i % 6);
    const Shape B = SomeShape(random, i / 6 % 6);
    const Eigen::Vector3d p = random.Point(1);
    const ContactQuery query{
        {A, Pose::FromQuaternion(p, random.Rotation())},
        {B, Pose::FromQuaternion(p + random.Point(1.5), random.Rotation())}};
    const ContactTruth truth = ComputeContactTruth(query);
    for (const int exponent : {-328, -200, 200, 328}) {
      const ContactQuery scaled{Scaled(query.A, exponent), Scaled(query.B, exponent)};
      const ContactTruth same = ComputeContactTruth(scaled);
      EXPECT_EQ(same.separation.lo, std::ldexp(truth.separation.lo, exponent));
      EXPECT_EQ(same.separation.hi, std::ldexp(truth.separation.hi, exponent));
      EXPECT_EQ(same.certificate.n_AB_W, truth.certificate.n_AB_W);
      EXPECT_EQ(same.touching, truth.touching);
      EXPECT_EQ(0 - Overlap(scaled, same.certificate.n_AB_W).hi, same.separation.lo);
    }
  }
}

}  // namespace
}  // namespace touchstone
