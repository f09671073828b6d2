#include "oracles/bullet/bullet_oracles.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace touchstone {
namespace {

using Eigen::Vector3d;

constexpr double kDoubleRoundoff = 0x1p-53;
constexpr double kFloatRoundoff = 0x1p-24;

// Scenes here reach 3 m from the origin, and an answer needs a few dozen operations.
constexpr double kRounding = 64 * 3 * kDoubleRoundoff;      // [m]
constexpr double kFloatRounding = 64 * 3 * kFloatRoundoff;  // [m]

const Oracle& Bullet(const std::string& name) {
  static const std::vector<std::unique_ptr<Oracle>> in_double =
      BulletOracles(BulletPrecision::kDouble);
  static const std::vector<std::unique_ptr<Oracle>> in_float =
      BulletOracles(BulletPrecision::kFloat);
  for (const auto* oracles : {&in_double, &in_float}) {
    for (const auto& oracle : *oracles) {
      if (oracle->info().name == name) return *oracle;
    }
  }
  throw std::invalid_argument(name);
}

const std::array<std::string, 4> kNames = {"bullet", "bullet/gjk", "bullet_float",
                                           "bullet_float/gjk"};

double RoundingOf(const Oracle& oracle) {
  return oracle.info().unit_roundoff == kFloatRoundoff ? kFloatRounding : kRounding;
}

Pose Turned(const Vector3d& p_WB, double angle, const Vector3d& axis) {
  return Pose::FromQuaternion(
      p_WB, Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.normalized())));
}

// A pose in which nothing is aligned with an axis or exact in binary.
const Pose kAwkward = Turned({0.31, -1.27, 0.83}, 0.7, {0.4, -0.9, 0.3});

/* Returns the pose of a body at `p_A` in the awkward frame, rotated with that frame. */
Pose At(const Vector3d& p_A) {
  return {kAwkward * p_A, kAwkward.R_WB, kAwkward.q_WB};
}

const Vector3d kAxis = kAwkward.R_WB.col(2);

/* A sphere above the +z face of a box, `separation` from it. */
ContactQuery SphereOverBox(double separation) {
  return {{Box{{0.7, 0.5, 0.3}}, kAwkward},
          {Sphere{1.0 / 3}, At({0.07, -0.03, 0.3 + 1.0 / 3 + separation})}};
}

TEST(BulletOracles, FloatAndDoubleAnswerInOneProcessEachWithItsOwnPrecision) {
  const ContactQuery query = {{Sphere{1.0 / 3}, At({0.1, 0.2, 0.3})},
                              {Sphere{0.7}, At({-0.3, 0.5, 1.1})}};
  // Distance of the centres (0.4, 0.3, 0.8) minus the radii.
  const double truth = std::sqrt(0.16 + 0.09 + 0.64) - 1.0 / 3 - 0.7;
  for (const std::string path : {"", "/gjk"}) {
    const ContactAnswer first = Bullet("bullet" + path).Answer(query);
    const ContactAnswer in_float = Bullet("bullet_float" + path).Answer(query);
    const ContactAnswer again = Bullet("bullet" + path).Answer(query);
    ASSERT_TRUE(first.separation && in_float.separation && again.separation) << path;
    EXPECT_EQ(*first.separation, *again.separation) << path;
    EXPECT_LE(std::abs(*first.separation - truth), kRounding) << path;
    EXPECT_LE(std::abs(*in_float.separation - truth), kFloatRounding) << path;
    // If it were the same library twice, the error would be that of doubles. This pose
    // is not exact in float.
    EXPECT_GT(std::abs(*in_float.separation - truth), 100 * kRounding) << path;
  }
}

TEST(BulletOracles, StateTheirPrecisionAndVersion) {
  for (const std::string& name : kNames) {
    const OracleInfo& info = Bullet(name).info();
    const bool in_float = name.starts_with("bullet_float");
    EXPECT_EQ(info.unit_roundoff, in_float ? kFloatRoundoff : kDoubleRoundoff) << name;
    EXPECT_EQ(info.library, "Bullet");
    EXPECT_TRUE(info.version.starts_with("3.")) << info.version;
    EXPECT_FALSE(info.isolated);
  }
}

TEST(BulletOracles, NormalPointsOutOfAIntoB) {
  for (const std::string& name : kNames) {
    const Oracle& oracle = Bullet(name);
    const ContactAnswer answer = oracle.Answer(SphereOverBox(-2e-3));
    ASSERT_TRUE(answer.touching && answer.n_AB_W && answer.separation) << name;
    const double allowed =
        RoundingOf(oracle) +
        oracle.info().For(ShapeKind::kBox, ShapeKind::kSphere).documented_error;
    EXPECT_NEAR(*answer.separation, -2e-3, allowed) << name;
    // The sphere's centre is a third of a metre from its surface, so a length error tilts
    // the normal by three times as many radians.
    EXPECT_LE((*answer.n_AB_W - kAxis).norm(), 3 * allowed) << name;
  }
}

TEST(BulletOracles, ContactIsMidwayBetweenTheSurfaces) {
  for (const std::string name : {"bullet", "bullet_float"}) {
    const Oracle& oracle = Bullet(name);
    const ContactAnswer answer = oracle.Answer(SphereOverBox(-2e-3));
    ASSERT_EQ(answer.points.size(), 1u) << name;
    // The face of the box is at z = 0.3, the lowest point of the sphere at z = 0.298.
    const Vector3d truth = kAwkward * Vector3d(0.07, -0.03, 0.299);
    EXPECT_LE((answer.points[0].p_WC - truth).norm(), RoundingOf(oracle)) << name;
    EXPECT_FALSE(answer.points[0].n_AB_W) << "repeats the answer's own normal";
  }
}

TEST(BulletOracles, NearbySurfacesDoNotTouchEvenIfTheManifoldHoldsAPoint) {
  for (const std::string& name : kNames) {
    const Oracle& oracle = Bullet(name);
    const ContactAnswer answer = oracle.Answer(SphereOverBox(1e-3));
    EXPECT_FALSE(answer.touching) << name;
    EXPECT_TRUE(answer.points.empty()) << name;
    ASSERT_TRUE(answer.separation) << name;
    EXPECT_NEAR(*answer.separation, 1e-3, RoundingOf(oracle)) << name;
  }
}

TEST(BulletOracles, ZeroSeparationCountsAsTouching) {
  // These numbers are exact in binary, and so is every operation on them.
  const ContactQuery query = {
      {Sphere{0.5}, Pose::FromQuaternion({1, 2, 3}, Eigen::Quaterniond::Identity())},
      {Sphere{0.25}, Pose::FromQuaternion({1, 2, 3.75}, Eigen::Quaterniond::Identity())}};
  for (const std::string& name : kNames) {
    const ContactAnswer answer = Bullet(name).Answer(query);
    ASSERT_TRUE(answer.separation) << name;
    EXPECT_EQ(*answer.separation, 0) << name;
    EXPECT_TRUE(answer.touching) << name;
  }
}

TEST(BulletOracles,
     DispatchReturnsFourContactsFaceOnFaceAndClosestPointsReturnWitnesses) {
  // B is rotated by 0.2 about the normal and stands well inside the face of A.
  const double half = 0.2;
  Pose X_WB = At({0.05, -0.04, 0.3 + half - 2e-3});
  X_WB = Pose::FromMatrix(X_WB.p_WB,
                          X_WB.R_WB * Eigen::AngleAxisd(0.2, Vector3d::UnitZ()).matrix());
  const ContactQuery query = {{Box{{0.7, 0.5, 0.3}}, kAwkward},
                              {Box{{half, half, half}}, X_WB}};
  const ContactAnswer dispatched = Bullet("bullet").Answer(query);
  EXPECT_EQ(dispatched.points.size(), 4u);
  EXPECT_FALSE(dispatched.witnesses);

  const ContactAnswer closest = Bullet("bullet/gjk").Answer(query);
  EXPECT_TRUE(closest.points.empty());
  ASSERT_TRUE(closest.witnesses);
  const double allowed =
      kRounding +
      Bullet("bullet/gjk").info().For(ShapeKind::kBox, ShapeKind::kBox).documented_error;
  EXPECT_NEAR((closest.witnesses->p_WCa - kAwkward.p_WB).dot(kAxis), 0.3, allowed);
  EXPECT_NEAR((closest.witnesses->p_WCb - kAwkward.p_WB).dot(kAxis), 0.298, allowed);
}

TEST(BulletOracles, MarginsNeitherRoundNorEnlargeAShape) {
  // The nearest corners of two cubes are sqrt(3)/2 apart. Bullet's own margins would make
  // this 0.92 (bulletphysics/bullet3#889) and enlarge the hull by 0.04.
  const Box box{{0.5, 0.5, 0.5}};
  ConvexHull hull;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) hull.vertices.emplace_back(x, y, z);
    }
  }
  const Pose X_WB = At({1.5, 1.5, 1.5});
  for (const std::string name : {"bullet/gjk", "bullet_float/gjk"}) {
    const Oracle& oracle = Bullet(name);
    const Shape shapes[] = {box, hull};
    for (const Shape& shape : shapes) {
      const ContactAnswer answer = oracle.Answer({{box, kAwkward}, {shape, X_WB}});
      ASSERT_TRUE(answer.separation) << name;
      EXPECT_NEAR(*answer.separation, std::sqrt(3.0) / 2, RoundingOf(oracle)) << name;
    }
  }
}

TEST(BulletOracles, SizesOfSmallShapesSurviveTheMargin) {
  // Bullet stores h - 0.04 and adds the 0.04 back: for h = 1e-6 only 11 digits remain.
  const double h = 1e-6 / 3;
  const ContactQuery query = {{Box{{h, h, h}}, Turned({0, 0, 0}, 0.7, {0.4, -0.9, 0.3})},
                              {HalfSpace{}, Turned({0, 0, 0}, 0.7, {0.4, -0.9, 0.3})}};
  const ContactAnswer answer = Bullet("bullet").Answer(query);
  ASSERT_TRUE(answer.separation);
  EXPECT_NEAR(*answer.separation, -h, 64 * h * kDoubleRoundoff);
}

TEST(BulletOracles, HalfSpaceIsAPlaneInEitherOrderAndUnsupportedByClosestPoints) {
  const Body plane = {HalfSpace{}, kAwkward};
  const Body cone = {Cone{0.4, 0.6}, At({0.2, 0.1, 0.6 - 3e-3})};
  for (const std::string name : {"bullet", "bullet_float"}) {
    const Oracle& oracle = Bullet(name);
    const ContactAnswer below = oracle.Answer({plane, cone});
    const ContactAnswer above = oracle.Answer({cone, plane});
    ASSERT_TRUE(below.separation && above.separation) << name;
    EXPECT_NEAR(*below.separation, -3e-3, RoundingOf(oracle)) << name;
    EXPECT_NEAR(*above.separation, -3e-3, RoundingOf(oracle)) << name;
    EXPECT_LE((*below.n_AB_W - kAxis).norm(), RoundingOf(oracle)) << name;
    EXPECT_LE((*above.n_AB_W + kAxis).norm(), RoundingOf(oracle)) << name;
  }
  const ContactAnswer refused = Bullet("bullet/gjk").Answer({plane, cone});
  EXPECT_EQ(refused.status, AnswerStatus::kUnsupported);
  EXPECT_FALSE(refused.reason.empty());
}

TEST(BulletOracles, PreparedBatchReturnsTheSeparationsOfTheAnswers) {
  const std::vector<ContactQuery> queries = {
      SphereOverBox(-2e-3),
      SphereOverBox(1e-3),
      {{Box{{0.7, 0.5, 0.3}}, kAwkward}, {Box{{0.2, 0.3, 0.4}}, At({0.6, 0.1, 0.65})}}};
  for (const std::string& name : kNames) {
    const Oracle& oracle = Bullet(name);
    const std::unique_ptr<PreparedBatch> batch = oracle.Prepare(queries);
    ASSERT_TRUE(batch) << name;
    for (int repeat = 0; repeat < 2; ++repeat) {
      batch->Run();
      ASSERT_EQ(batch->separations().size(), queries.size());
      for (std::size_t i = 0; i < queries.size(); ++i) {
        const ContactAnswer answer = oracle.Answer(queries[i]);
        ASSERT_TRUE(answer.separation) << name << ", question " << i;
        EXPECT_EQ(batch->separations()[i], *answer.separation)
            << name << ", question " << i;
      }
    }
  }
}

}  // namespace
}  // namespace touchstone
