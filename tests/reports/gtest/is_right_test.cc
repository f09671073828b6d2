#include "reports/gtest/is_right.h"

#include <gmock/gmock.h>

#include "oracles/function_oracle.h"

namespace touchstone {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/** Two spheres in the arithmetic `Scalar`. The depth is stated `more` deeper [m]. */
template <typename Scalar>
std::unique_ptr<Oracle> Spheres(const Promises& promises, double more = 0) {
  return MakeOracle<Sphere, Sphere>(
      "mine",
      [more](const Sphere& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB) {
        const Eigen::Matrix<Scalar, 3, 1> p_AB =
            X_WB.p_WB.cast<Scalar>() - X_WA.p_WB.cast<Scalar>();
        const Scalar distance = p_AB.norm();
        const Scalar depth =
            static_cast<Scalar>(A.radius) + static_cast<Scalar>(B.radius) - distance;
        ContactAnswer answer;
        answer.status = AnswerStatus::kAnswered;
        answer.touching = depth >= 0;
        if (!answer.touching) return answer;
        answer.separation = -static_cast<double>(depth) - more;
        const Eigen::Matrix<Scalar, 3, 1> n_W =
            distance > 0 ? Eigen::Matrix<Scalar, 3, 1>(p_AB / distance)
                         : Eigen::Matrix<Scalar, 3, 1>::UnitX();
        answer.n_AB_W = n_W.template cast<double>();
        return answer;
      },
      promises);
}

/** A tolerance of `length` [m] that section 4 documents. */
Promises Promised(double length) {
  Promises promises;
  promises.tolerance.length = length;
  promises.documented_by = "section 4";
  return promises;
}

QuestionSeries SpheresOf(Family family) {
  return {
      .family = family, .A = ShapeKind::kSphere, .B = ShapeKind::kSphere, .count = 100};
}

class IsRightOf : public testing::TestWithParam<Family> {};

TEST_P(IsRightOf, AFloatRoutineThatSaysSo) {
  const auto mine = Spheres<float>({.precision = Precision::kFloat});
  EXPECT_TRUE(IsRight(*mine, SpheresOf(GetParam())));
}

TEST_P(IsRightOf, ADoubleRoutine) {
  EXPECT_TRUE(IsRight(*Spheres<double>({}), SpheresOf(GetParam())));
}

INSTANTIATE_TEST_SUITE_P(Families, IsRightOf,
                         testing::Values(Family::kRandom, Family::kDeep,
                                         Family::kTouching),
                         [](const auto& family) {
                           return std::string(NameOf(family.param));
                         });

TEST(IsRight, RefusesAFloatRoutineThatClaimsDoubles) {
  EXPECT_FALSE(IsRight(*Spheres<float>({}), SpheresOf(Family::kRandom)));
}

// A scene of the family is some metres large, so that 1e-3 m is far above rounding.
TEST(IsRight, GrantsTheToleranceOfTheTestAndNoMore) {
  const auto mine = Spheres<double>({}, 1e-3);
  const QuestionSeries series = SpheresOf(Family::kRandom);
  EXPECT_FALSE(IsRight(*mine, series));
  EXPECT_FALSE(IsRight(*mine, series, {}, {.tolerance = {.length = 0.999e-3}}));
  EXPECT_TRUE(IsRight(*mine, series, {}, {.tolerance = {.length = 1.001e-3}}));
}

// The depth is wrong wherever the spheres overlap, so unit spheres show it too.
TEST(IsRight, ShowsTheGravestFailureShrunk) {
  const testing::AssertionResult result =
      IsRight(*Spheres<double>({}, 1e-3), SpheresOf(Family::kRandom));
  const std::string message = result.message();
  EXPECT_THAT(message, HasSubstr("The gravest, shrunk ("));
  const std::size_t shrunk = message.find("radius = 1.0\n");
  const std::size_t before = message.find("Before it was shrunk:");
  ASSERT_NE(shrunk, std::string::npos) << message;
  ASSERT_NE(before, std::string::npos) << message;
  EXPECT_LT(shrunk, before);
  EXPECT_THAT(message, HasSubstr("position = [0.0, 0.0, 0.0]"));
  EXPECT_THAT(message, HasSubstr("source = \"Shrunk from sweep/random/sphere_sphere/"));
}

TEST(IsRight, GrantsTheToleranceOfTheRoutineAndNoMore) {
  const QuestionSeries series = SpheresOf(Family::kRandom);
  EXPECT_FALSE(IsRight(*Spheres<double>(Promised(0.999e-3), 1e-3), series));
  EXPECT_TRUE(IsRight(*Spheres<double>(Promised(1.001e-3), 1e-3), series));
}

TEST(IsRight, SaysWhoStatesATolerance) {
  const auto promised = Spheres<double>(Promised(1e-5), 1);
  const QuestionSeries series = SpheresOf(Family::kRandom);
  EXPECT_THAT(IsRight(*promised, series).message(),
              AllOf(HasSubstr("1e-05 m stated by section 4"),
                    HasSubstr("Granted to mine beyond rounding: 1e-05 m, stated by "
                              "section 4")));
  EXPECT_THAT(IsRight(*promised, series, {}, {.tolerance = {.share = 1e-5}}).message(),
              AllOf(HasSubstr("1e-05 of the scene's size stated by the test"),
                    Not(HasSubstr("section 4"))));
  EXPECT_THAT(IsRight(*Spheres<double>({}, 1), series).message(),
              Not(HasSubstr("Granted")));
}

}  // namespace
}  // namespace touchstone
