#include "reports/worlds/law_support/prediction.h"

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/worlds/law_support/envelope.h"
#include "reports/worlds/laws/laws.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

const OracleInfo kEngine = [] {
  OracleInfo info;
  info.name = "engine";
  info.unit_roundoff = 1e-10;
  info.slop = 0.25;
  info.slop_documented_by = "its manual";
  return info;
}();

// 64 roundings in each of 9 steps and in reading the world.
constexpr double kRounding = 64 * 1e-10 * 10;

TEST(ToleranceOf, SumsEachPartWithItsFactor) {
  EXPECT_DOUBLE_EQ(ToleranceOf({}, kEngine, 9), 0);
  EXPECT_DOUBLE_EQ(ToleranceOf({.scheme = 2}, kEngine, 9), 3);
  EXPECT_DOUBLE_EQ(ToleranceOf({.solved = 2}, kEngine, 9), 2 * (1e-5 + kRounding));
  EXPECT_DOUBLE_EQ(ToleranceOf({.computed = 2}, kEngine, 9), 2 * kRounding);
  EXPECT_DOUBLE_EQ(ToleranceOf({.slop = 0.25}, kEngine, 9), 0.25);
  EXPECT_DOUBLE_EQ(
      ToleranceOf({.scheme = 1, .solved = 2, .computed = 3, .slop = 4}, kEngine, 9),
      1.5 + 2 * (1e-5 + kRounding) + 3 * kRounding + 4);
}

TEST(AllowedWords, NameThePartsThatAreThere) {
  EXPECT_EQ(AllowedWords{}.Because(kEngine), "64 roundings per step");
  EXPECT_EQ((AllowedWords{.scheme = "½ a h t"}.Because(kEngine)),
            "1.5 × ½ a h t, and 64 roundings per step");
  EXPECT_EQ((AllowedWords{.solved = "the velocity"}.Because(kEngine)),
            "1e-5 of the velocity for the solver, and 64 roundings per step");
  EXPECT_THAT((AllowedWords{.scheme = "V h", .slop = true}.Because(kEngine)),
              testing::AllOf(testing::StartsWith("1.5 × V h, and 64 roundings per step"),
                             testing::HasSubstr("slop of 0.25 m"),
                             testing::HasSubstr("its manual")));
}

TEST(AllowedWords, GrantNoMoreThanTheyName) {
  EXPECT_EQ(AllowedWords{}.GrantsOf(), Grants::kRounding);
  EXPECT_EQ((AllowedWords{.solved = "the velocity"}.GrantsOf()), Grants::kSolver);
  EXPECT_EQ((AllowedWords{.scheme = "V h", .solved = "the velocity"}.GrantsOf()),
            Grants::kStep);
}

/** A ball at rest, of which four samples are taken, every second step. */
World Resting() {
  World world;
  world.bodies = {BodyOf("ball", Sphere{0.5}, 1, {0, 1, 0})};
  world.dt = 0.1;
  world.steps = 6;
  world.sample_every = 2;
  return world;
}

Trajectory MotionOf(const World& world) {
  return Stepped(world, [](WorldState& state) { state.bodies[0].p_WB.x() += 0.1; });
}

TEST(Envelope, KeepsTheLargestErrorSoFarOfAllSchemes) {
  const World world = Resting();
  const Trajectory trajectory = MotionOf(world);
  const Motion motion{world, kEngine, trajectory};
  Envelope envelope(motion);
  int steps = 0;
  // Off by 1 at the second sample only.
  envelope.Include([&] { ++steps; },
                   [](std::size_t s) {
                     return Apart{s == 1 ? 1.0 : 0.0, 0};
                   });
  EXPECT_EQ(steps, 6);
  // Off by the number of steps over four.
  steps = 0;
  envelope.Include([&] { ++steps; },
                   [&](std::size_t /*s*/) {
                     return Apart{steps / 4.0, steps * 1.0};
                   });
  EXPECT_EQ(envelope.At(0).place, 0);
  EXPECT_EQ(envelope.At(1).place, 1);
  EXPECT_EQ(envelope.At(2).place, 1);
  EXPECT_EQ(envelope.At(3).place, 1.5);
  EXPECT_EQ(envelope.At(3).speed, 6);
}

TEST(JudgePredictions, JudgesWhatIsPredictedOfEachSample) {
  const World world = Resting();
  const Trajectory trajectory = MotionOf(world);
  const Motion motion{world, kEngine, trajectory};
  // It moves by 0.2 m from sample to sample; the law has it at rest until the third.
  const auto judged = [&](double allowed) {
    return JudgePredictions(motion, {.position = {{.scheme = "a guess"}, "it is at"}},
                            {{"ball", StateOfBody(0), [&](std::size_t s) {
                                PredictedState predicted;
                                if (s < 3) {
                                  predicted.position =
                                      Predicted{world.bodies[0].placed.X_WB.p_WB,
                                                {.scheme = allowed}};
                                }
                                return predicted;
                              }}});
  };
  const std::vector<Worst> found = judged(0.2);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found.front().IsBeyond());
  EXPECT_NEAR(found.front().finding().value, 0.4, 1e-12);
  EXPECT_NEAR(found.front().finding().tolerance.value, 0.3, 1e-12);
  EXPECT_EQ(found.front().finding().measure, MeasureKind::kPositionError);
  EXPECT_THAT(found.front().finding().proof, testing::HasSubstr("; it is at (0, 1, 0)"));
  EXPECT_FALSE(judged(0.3).front().IsBeyond());
}

TEST(Laws, AreFoundByTheirOlderNames) {
  for (const auto& [older, name] : {std::pair("particle_flight", "ballistic"),
                                    std::pair("particle_bounce", "bounce_series"),
                                    std::pair("double_pendulum", "pendulum"),
                                    std::pair("oblique_impact", "sphere_impact")}) {
    const Law* law = FindLaw(older);
    ASSERT_NE(law, nullptr) << older;
    EXPECT_EQ(law->name, name);
  }
  EXPECT_EQ(FindLaw("newton"), nullptr);
}

TEST(Laws, HaveNoNameTwice) {
  std::vector<std::string_view> names;
  for (const Law& law : Laws()) {
    names.push_back(law.name);
    names.insert(names.end(), law.aliases.begin(), law.aliases.end());
  }
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

}  // namespace
}  // namespace touchstone
