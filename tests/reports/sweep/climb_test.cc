#include "reports/sweep/climb.h"

#include <gtest/gtest.h>

#include "scenarios/scenario_file.h"
#include "scenarios/validate.h"
#include "tests/reports/sweep/spheres.h"

namespace touchstone {
namespace {

constexpr QuestionSeries kClimbs = {.family = Family::kRandom,
                                    .A = ShapeKind::kSphere,
                                    .B = ShapeKind::kSphere,
                                    .seed = 5,
                                    .first = 0,
                                    .count = std::uint64_t{3} * 64,
                                    .climb = 64};

/** Returns the depth as a share of the smaller sphere's diameter. */
double RelativeDepth(const ContactQuery& query) {
  const double a = std::get<Sphere>(query.A.shape).radius;
  const double b = std::get<Sphere>(query.B.shape).radius;
  const double distance = (query.B.X_WB.p_WB - query.A.X_WB.p_WB).norm();
  return (a + b - distance) / (2 * std::min(a, b));
}

TEST(ClimbOf, StartsWithTheFamilyAndGetsWorse) {
  const auto half = Spheres("half", 0.5);  // Off by half of the depth.
  const TrueQuestions questions = ClimbOf(kClimbs, *half);
  ASSERT_EQ(questions.scenarios.size(), kClimbs.count);
  int climbed = 0;
  for (std::size_t start = 0; start < kClimbs.count; start += kClimbs.climb) {
    const ContactQuery& first = questions.scenarios[start].contact;
    EXPECT_EQ(WriteScenario(questions.scenarios[start]),
              WriteScenario(ScenarioAt(kClimbs, start)));
    double deepest = RelativeDepth(first);
    for (std::size_t i = start; i < start + kClimbs.climb; ++i) {
      const ContactQuery& query = questions.scenarios[i].contact;
      EXPECT_TRUE(FaultsOf(query).empty());
      deepest = std::max(deepest, RelativeDepth(query));
    }
    // Spheres apart have no error, and then nothing tells a better way.
    if (RelativeDepth(first) <= 0) continue;
    EXPECT_GT(deepest, RelativeDepth(first) + 0.1);
    ++climbed;
  }
  EXPECT_GT(climbed, 0);
}

TEST(ClimbOf, IsAPureFunctionOfTheIndex) {
  const auto half = Spheres("half", 0.5);  // Off by half of the depth.
  const TrueQuestions all = ClimbOf(kClimbs, *half);
  QuestionSeries part = kClimbs;
  part.first = 100;
  part.count = 50;
  const TrueQuestions some = ClimbOf(part, *half);
  ASSERT_EQ(some.scenarios.size(), part.count);
  for (std::size_t i = 0; i < part.count; ++i) {
    EXPECT_EQ(WriteScenario(some.scenarios[i]), WriteScenario(all.scenarios[100 + i]));
    EXPECT_EQ(some.truths[i].separation.lo, all.truths[100 + i].separation.lo);
  }
}

}  // namespace
}  // namespace touchstone
