// Tests that a certificate proves what it says, and that one that does not is not
// believed.

#include <cmath>
#include <limits>
#include <variant>

#include <gtest/gtest.h>

#include "reports/referee/proved.h"
#include "reports/referee/referee.h"
#include "reports/referee/support.h"
#include "reports/referee/witnesses.h"
#include "tests/reports/referee/awkward_scene.h"
#include "tests/reports/referee/random_scene.h"

namespace touchstone::referee {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Shape SomeShape(RandomScene& random, int kind) {
  const double a = random.Uniform(0.1, 1);
  const double b = random.Uniform(0.1, 1);
  switch (kind) {
    case 0:
      return Sphere{a};
    case 1:
      return random.SomeBox(1);
    case 2:
      return Capsule{a, b};
    case 3:
      return Cylinder{a, b};
    case 4:
      return Cone{a, b};
    case 5:
      return random.SomeHull(1, 9);
    default:
      return HalfSpace{};
  }
}

/** Returns the pair number i of a family of all pairs of kinds: anywhere, aligned, or
 moved along the normal until they touch to within 1e-17 to 1e-3 m. */
ContactQuery SomePair(RandomScene& random, int i) {
  const int A = i % 6;
  const int B = i / 6 % 7;
  const bool aligned = i / 42 % 2 == 1;
  const Eigen::Vector3d p = random.Point(1);
  ContactQuery query{{SomeShape(random, A), Pose::FromQuaternion(p, random.Rotation())},
                     {SomeShape(random, B),
                      Pose::FromQuaternion(p + random.Point(1.5), random.Rotation())}};
  if (aligned) query.B.X_WB.R_WB = query.A.X_WB.R_WB;
  if (i / 84 % 2 == 1) return query;
  const ContactTruth truth = ComputeContactTruth(query);
  const double gap = random.Uniform(-1, 1) * random.Power(-17, -3);
  query.B.X_WB.p_WB += (gap - truth.separation.lo) * truth.certificate.n_AB_W;
  return query;
}

TEST(Certificate, ProvesItsBoundsForEveryPairOfShapes) {
  RandomScene random(30);
  int apart = 0;
  int touching = 0;
  for (int i = 0; i < 1008; ++i) {
    const ContactQuery query = SomePair(random, i);
    const ContactTruth truth = ComputeContactTruth(query);
    const auto& [n, p_A, p_B] = truth.certificate;
    SCOPED_TRACE(testing::Message() << "pair " << i);
    // Rounding a point moves it by half an ulp of each coordinate, and the distance from
    // the surface has a rounding of its own.
    const double ulp = std::numeric_limits<double>::epsilon() * SceneSize(query);
    EXPECT_NEAR(n.norm(), 1, 4 * std::numeric_limits<double>::epsilon());
    // Near touching the overlap is evaluated with more digits than the bound.
    const double proved = 0 - Overlap(query, n).hi;
    EXPECT_GE(proved, truth.separation.lo);
    EXPECT_LE(proved - truth.separation.lo,
              std::max(0x1p-90 * SceneSize(query), 0x1p-52 * std::abs(proved)));
    EXPECT_LE(SignedDistance(query.A, p_A).lo, 8 * ulp);
    EXPECT_LE(SignedDistance(query.B, p_B).lo, 8 * ulp);
    if (truth.separation.lo > 0) {
      EXPECT_LE((p_B - p_A).norm(), truth.separation.hi + 8 * ulp);
      EXPECT_GE(n.dot(p_B - p_A), truth.separation.lo - 8 * ulp);
      ++apart;
    }
    touching += truth.separation.hi < 0;
  }
  EXPECT_GT(apart, 250);
  EXPECT_GT(touching, 250);
}

TEST(AreProvedApart, AgreesWithTheCertificateForEveryPairOfShapes) {
  RandomScene random(31);
  int apart = 0;
  int proved = 0;
  for (int i = 0; i < 1008; ++i) {
    const ContactQuery query = SomePair(random, i);
    const Enclosure separation = ComputeContactTruth(query).separation;
    const bool is_clear = !std::holds_alternative<HalfSpace>(query.B.shape) &&
                          separation.lo > 1e-9 * SceneSize(query);
    apart += is_clear;
    if (!AreProvedApart(query)) continue;
    EXPECT_GT(separation.lo, 0) << "pair " << i;
    proved += is_clear;
  }
  EXPECT_GT(apart, 200);
  // A search in doubles may end before the direction that separates round shapes.
  EXPECT_GT(proved, apart - apart / 20);
}

// A box 0.1 m above another, and the certificate of a search that went well.
class WrongCertificate : public testing::Test {
 protected:
  WrongCertificate() {
    core.separation = {0.1, 0.1};
    core.n_AB_W = {0, 0, 1};
    core.points.count = 1;
    core.points.weights[0] = 1;
    core.points.q_A[0] = {0.25, 0.25, 0.5};
    core.points.q_B[0] = {0.25, 0.25, -0.5};
  }

  ContactQuery query{{Box{{0.5, 0.5, 0.5}}, Pose{}},
                     {Box{{0.5, 0.5, 0.5}},
                      Pose::FromMatrix({0, 0, 1.125}, Eigen::Matrix3d::Identity())}};
  CoreTruth<Precise> core;
};

TEST_F(WrongCertificate, IsNotThis) {
  EXPECT_EQ(Proved(query, core).lo, 0.125);
  EXPECT_EQ(Proved(query, core).hi, 0.125);
}

TEST_F(WrongCertificate, ProvesNoMoreThanItsDirection) {
  core.n_AB_W = Eigen::Vector3d(0, 0.6, 0.8);
  EXPECT_NEAR(Proved(query, core).lo, 0.8 * 0.125 - 0.6, 1e-15);
  EXPECT_EQ(Proved(query, core).hi, 0.125);
}

TEST_F(WrongCertificate, ProvesNothingWithoutADirection) {
  core.n_AB_W.setZero();
  EXPECT_EQ(Proved(query, core).lo, -kInfinity);
}

TEST_F(WrongCertificate, ProvesNoMoreThanItsPoints) {
  core.points.q_B[0].x = 0.5;
  EXPECT_EQ(Proved(query, core).lo, 0.125);
  EXPECT_NEAR(Proved(query, core).hi, std::hypot(0.125, 0.25), 1e-15);
}

TEST_F(WrongCertificate, ProvesNothingByAPointOutside) {
  core.points.q_B[0].z = std::nextafter(-0.5, -1);
  EXPECT_EQ(Proved(query, core).hi, kInfinity);
}

TEST_F(WrongCertificate, ProvesNothingIfItsBoundsContradictEachOther) {
  core.is_deep = true;
  core.separation = {-0.1, -0.1};
  EXPECT_EQ(Proved(query, core).lo, -kInfinity);
  EXPECT_EQ(Proved(query, core).hi, kInfinity);
}

// The other body is a ball of radius zero at the origin, so the separation is the
// distance.
double DistanceProvedBy(const Shape& shape, const Eigen::Vector3d& q) {
  Witnesses<Precise> points;
  points.count = 1;
  points.weights[0] = 1;
  points.q_A[0] = Exactly<Precise>(q);
  points.q_B[0] = {0, 0, 0};
  return ProvedSeparation({{shape, Pose{}}, {Sphere{0}, Pose{}}}, points);
}

TEST(Witnesses, CountOnlyInsideTheirShapes) {
  const double more = std::nextafter(0.5, 1);
  EXPECT_EQ(DistanceProvedBy(Sphere{0.5}, {0, 0, 0}), -0.5);
  EXPECT_EQ(DistanceProvedBy(Sphere{0.5}, {1e-300, 0, 0}), kInfinity);
  EXPECT_EQ(DistanceProvedBy(Capsule{0.25, 0.5}, {0, 0, 0.5}), 0.25);
  EXPECT_EQ(DistanceProvedBy(Capsule{0.25, 0.5}, {0, 0, more}), kInfinity);
  EXPECT_EQ(DistanceProvedBy(Capsule{0.25, 0.5}, {0, 1e-9, 0}), kInfinity);
  EXPECT_EQ(DistanceProvedBy(Box{{1, 0.5, 2}}, {0, -0.5, 0}), 0.5);
  EXPECT_EQ(DistanceProvedBy(Box{{1, 0.5, 2}}, {0, -more, 0}), kInfinity);
  EXPECT_EQ(DistanceProvedBy(Cylinder{0.5, 2}, {0.3, 0.4, 0}), kInfinity);  // 0.4 > 2/5.
  EXPECT_NEAR(DistanceProvedBy(Cylinder{0.5, 2}, {0.29999, 0.4, 0}), 0.5, 1e-5);
  EXPECT_EQ(DistanceProvedBy(Cylinder{0.5, 2}, {0, 0, -2.0000001}), kInfinity);
  EXPECT_EQ(DistanceProvedBy(Cone{0.5, 0.5}, {0, 0, 0.5}), 0.5);
  EXPECT_EQ(DistanceProvedBy(Cone{0.5, 0.5}, {0.25, 0, 0}), kInfinity);
  EXPECT_NEAR(DistanceProvedBy(Cone{0.5, 0.5}, {0.5, 0, -0.5}), std::sqrt(0.5), 1e-15);
  EXPECT_EQ(DistanceProvedBy(Cone{0.5, 0.5}, {more, 0, -0.5}), kInfinity);
  const ConvexHull hull{{{0, 0, 1}, {0, 0, 2}}};
  EXPECT_EQ(DistanceProvedBy(hull, {0, 0, 1}), 1);
  EXPECT_EQ(DistanceProvedBy(hull, {0, 0, 1.5}), kInfinity);
}

TEST(Witnesses, CountOnlyAsConvexCombinations) {
  Witnesses<Precise> points;
  points.count = 2;
  points.weights = {3, 1};
  points.q_A[0] = Exactly<Precise>(Eigen::Vector3d(0, 0, 1));
  points.q_A[1] = Exactly<Precise>(Eigen::Vector3d(0, 0, -1));
  points.q_B[0] = points.q_B[1] = {0, 0, 0};
  const ContactQuery query{{Box{{1, 1, 1}}, Pose{}}, {Sphere{0}, Pose{}}};
  EXPECT_EQ(ProvedSeparation(query, points), 0.5);
  points.weights[1] = -1;
  EXPECT_EQ(ProvedSeparation(query, points), kInfinity);
  points.count = 0;
  EXPECT_EQ(ProvedSeparation(query, points), kInfinity);
}

// The formulas of the check and of the searches agree, for every shape and direction.
TEST(Support, IsThatOfTheCores) {
  RandomScene random(31);
  for (int i = 0; i < 300; ++i) {
    const Body body{SomeShape(random, i % 6),
                    Pose::FromQuaternion(random.Point(1), random.Rotation())};
    const Eigen::Vector3d n =
        i % 5 == 0 ? Eigen::Vector3d(body.X_WB.R_WB.col(i % 3)) : random.Point(1);
    const Body origin{Sphere{0}, Pose{}};
    const MinkowskiDifference M(body, origin);
    const Bounded<Precise> core =
        M.SupportValue(Exactly<Bounded<Precise>>(n)) +
        Bounded<Precise>(M.A().radius) * Norm(Exactly<Bounded<Precise>>(n));
    const Bounded<Precise> difference = SupportOf<Precise>(body, n) - core;
    EXPECT_LE(difference.enclosure().lo, 0);
    EXPECT_GE(difference.enclosure().hi, 0);
    EXPECT_LE(difference.enclosure().hi - difference.enclosure().lo, 1e-60);
  }
}

}  // namespace
}  // namespace touchstone::referee
