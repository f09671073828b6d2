#include "oracles/libccd/ccd_oracles.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/oracles/constructed_contact.h"

namespace touchstone {
namespace {

constexpr double kDepth = 2e-3;  // [m]

const Oracle& Epa() {
  static const auto oracles = CcdOracles();
  return *oracles.at(0);
}

const Oracle& Mpr() {
  static const auto oracles = CcdOracles();
  return *oracles.at(1);
}

bool HasHalfSpace(ShapeKind a, ShapeKind b) {
  return a == ShapeKind::kHalfSpace || b == ShapeKind::kHalfSpace;
}

TEST(CcdOracles, AreIsolatedEpaAndInProcessMpr) {
  EXPECT_EQ(Epa().info().name, "libccd/epa");
  EXPECT_TRUE(Epa().info().isolated);
  EXPECT_EQ(Mpr().info().name, "libccd/mpr");
  EXPECT_FALSE(Mpr().info().isolated);
  EXPECT_FALSE(Mpr().info().version.empty());
}

TEST(CcdOracles, SupportAllShapesExceptHalfSpaces) {
  for (const Oracle* oracle : {&Epa(), &Mpr()}) {
    for (const auto& [a, b] : AllPairs()) {
      EXPECT_EQ(oracle->info().For(a, b).supported, !HasHalfSpace(a, b));
    }
    const auto contact = PutTogether(ShapeKind::kBox, ShapeKind::kHalfSpace, -kDepth);
    EXPECT_EQ(oracle->Answer(contact.query).status, AnswerStatus::kUnsupported);
  }
}

// MPR is exact only if the portal's direction is that of the least depth: flat against
// flat, or along the line of the centres. Its errors for other pairs do not concern the
// conventions that this test checks.
TEST(CcdMpr, AnswersInTheProjectsConventions) {
  for (const auto& [a, b] : AllPairs()) {
    if (HasHalfSpace(a, b)) continue;
    SCOPED_TRACE(std::string(NameOf(a)) + " against " + std::string(NameOf(b)));
    const ConstructedContact deep = PutTogether(a, b, -kDepth);
    const ContactAnswer answer = Mpr().Answer(deep.query);
    EXPECT_TRUE(answer.separation && answer.n_AB_W);
    EXPECT_EQ(answer.points.size(), 1u);
    // A wrong sign or frame is off by the depth itself.
    ExpectMatches(answer, deep, {kDepth / 4, 0.05, kDepth});

    const ConstructedContact apart = PutTogether(a, b, kDepth);
    const ContactAnswer none = Mpr().Answer(apart.query);
    ExpectMatches(none, apart, {0, 0, 0});
    EXPECT_FALSE(none.separation || none.n_AB_W || !none.points.empty());
  }
}

// EPA's direction is sometimes NaN (libccd issue #44, FCL pull request #305), so only the
// pairs that it solves are checked. The sign of its direction is that of MPR.
TEST(CcdEpa, AnswersInTheProjectsConventions) {
  int right = 0;
  for (const auto& [a, b] : AllPairs()) {
    if (HasHalfSpace(a, b)) continue;
    SCOPED_TRACE(std::string(NameOf(a)) + " against " + std::string(NameOf(b)));
    const ConstructedContact deep = PutTogether(a, b, -kDepth);
    const ContactAnswer answer = Epa().Answer(deep.query);
    if (answer.status != AnswerStatus::kAnswered || !answer.touching) continue;
    const double along = answer.n_AB_W->dot(deep.n_AB_W);
    if (!(std::abs(*answer.separation + kDepth) < kDepth / 4)) continue;
    EXPECT_GT(along, 0.9);
    ++right;
  }
  EXPECT_GE(right, 18);
}

// libccd issue #25: an origin on the boundary of the simplex results in 0/0.
TEST(CcdEpa, PassesOnADirectionThatIsNaN) {
  const Body A = {Box{{1, 1, 1}}, {}};
  const Body B = {Box{{1, 1, 1}}, Pose::FromQuaternion({0, 0, 1.9}, {1, 0, 0, 0})};
  const ContactAnswer answer = Epa().Answer({A, B});
  ASSERT_EQ(answer.status, AnswerStatus::kAnswered);
  ASSERT_TRUE(answer.n_AB_W);
  EXPECT_TRUE(answer.n_AB_W->hasNaN());
}

// The spheres are those of contact/sphere_sphere/nearly_concentric, scaled. Without the
// limit, EPA answers after about 31,168 support points.
TEST(CcdEpa, IsStoppedByACountOfSupportPointsInsteadOfATime) {
  const Eigen::Vector3d p_WA(-0.40990668019244275, 0.508108728496903,
                             -1.4664471105465984);
  const Eigen::Vector3d p_WB(-0.40990668015359477, 0.5081087284064314,
                             -1.4664471105640828);
  const Body A = {Sphere{0.105}, Pose::FromQuaternion(0.5 * p_WA, {1, 0, 0, 0})};
  const Body B = {Sphere{0.465}, Pose::FromQuaternion(0.5 * p_WB, {1, 0, 0, 0})};
  const ContactAnswer answer = Epa().Answer({A, B});
  EXPECT_EQ(answer.status, AnswerStatus::kTimedOut);
  EXPECT_EQ(answer.reason, "gave up at support point 20000");
}

TEST(CcdMpr, PreparedBatchReturnsTheSeparationsOfTheAnswers) {
  std::vector<ContactQuery> queries;
  for (const double separation : {-0.1, 0.003, -0.02}) {
    queries.push_back(PutTogether(ShapeKind::kBox, ShapeKind::kCone, separation).query);
  }
  const auto batch = Mpr().Prepare(queries);
  batch->Run();
  EXPECT_EQ(batch->separations()[0], Mpr().Answer(queries[0]).separation);
  EXPECT_TRUE(std::isnan(batch->separations()[1]));
  EXPECT_EQ(batch->separations()[2], Mpr().Answer(queries[2]).separation);
}

}  // namespace
}  // namespace touchstone
