#include "reports/sweep/question_id.h"

#include <cstdint>
#include <limits>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

TEST(QuestionOfId, ReturnsTheQuestionThatHasTheId) {
  const QuestionSeries series{.family = Family::kEdgeEdge,
                              .A = ShapeKind::kConvexHull,
                              .B = ShapeKind::kHalfSpace,
                              .seed = std::numeric_limits<std::uint64_t>::max(),
                              .first = 40,
                              .count = 9};
  const auto question = QuestionOfId(ScenarioAt(series, 42).id);
  ASSERT_TRUE(question);
  EXPECT_EQ(CountOf(*question), 1U);
  EXPECT_EQ(WriteScenario(ScenarioAt(std::get<QuestionSeries>(*question), 42)),
            WriteScenario(ScenarioAt(series, 42)));
}

TEST(QuestionOfId, ReturnsTheWorldThatHasTheId) {
  const WorldSeries series{.family = WorldFamily::kMassRatios, .seed = 5};
  const auto question = QuestionOfId(WorldAt(series, 3).id);
  ASSERT_TRUE(question);
  EXPECT_EQ(WriteScenario(WorldAt(std::get<WorldSeries>(*question), 3)),
            WriteScenario(WorldAt(series, 3)));
}

TEST(QuestionOfId, AcceptsAnIndexWithoutLeadingZeros) {
  const auto question = QuestionOfId("sweep/random/box_box/seed_1/42");
  ASSERT_TRUE(question);
  EXPECT_EQ(IdOf(*question, 42), "sweep/random/box_box/seed_1/00000000000000000042");
}

TEST(QuestionOfId, IsEmptyForTextsThatAreNoQuestion) {
  for (const std::string id :
       {"", "sweep", "sweep/random/box_box/seed_1", "sweep/random/box_box/seed_1/",
        "sweep/random/box_box/seed_1/x", "sweep/random/box_box/seed_1/-1",
        "sweep/random/box_box/seed_1/1/2", "sweep/random/box_box/1/1",
        "sweep/rando/box_box/seed_1/1", "sweep/random/box_bo/seed_1/1",
        "sweep/random/half_space_half_space/seed_1/1", "sweep/world/random/seed_1/1",
        "sweep/random/box_box/seed_18446744073709551616/1",
        "contact/random/box_box/seed_1/1",
        // It depends on the oracle that was searched.
        "sweep/random/box_box/seed_1/climb_32/1"})
    EXPECT_FALSE(QuestionOfId(id)) << id;
}

}  // namespace
}  // namespace touchstone
