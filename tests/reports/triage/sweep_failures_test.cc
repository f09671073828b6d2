#include "reports/triage/sweep_failures.h"

#include <memory>
#include <set>

#include <gtest/gtest.h>

#include "oracles/no_answer.h"
#include "reports/sweep/sweep.h"
#include "tests/reports/fake_oracle.h"

namespace touchstone {
namespace {

/** Returns the failures of a sweep. */
Failures FailuresOf(const SweepPlan& plan) {
  SweepFile file = SweepFile::Create(":memory:", SettingsOf(plan), SweepJournal::kNone);
  Sweep(plan, file, {});
  std::set<std::string> names;
  for (const Oracle* const oracle : plan.subjects) names.insert(oracle->info().name);
  return FailuresOf(file, names);
}

/** Returns the failures of a sweep over spheres and boxes in both orders. */
Failures FailuresOfASweep(const std::vector<const Oracle*>& subjects) {
  SweepPlan plan;
  plan.subjects = subjects;
  for (const Family family : {Family::kRandom, Family::kDeep}) {
    for (const auto& [A, B] : {std::pair(ShapeKind::kBox, ShapeKind::kSphere),
                               std::pair(ShapeKind::kSphere, ShapeKind::kBox)}) {
      plan.series.emplace_back(
          QuestionSeries{.family = family, .A = A, .B = B, .count = 40});
    }
  }
  return FailuresOf(plan);
}

TEST(Symptoms, JoinFamiliesAndBothOrdersOfAPair) {
  const FakeOracle deep =
      FakeOracle::Wrong("deep", [](const ContactQuery&, ContactAnswer& answer) {
        if (answer.separation && answer.touching) *answer.separation *= 2;
      });
  const Failures failures = FailuresOfASweep({&deep});
  ASSERT_FALSE(failures.symptoms.empty());
  std::uint64_t failed = 0;
  for (const Symptom& symptom : failures.symptoms) {
    EXPECT_EQ(symptom.key.oracle, "deep");
    EXPECT_EQ(symptom.key.of, "box and sphere");
    EXPECT_FALSE(symptom.kept.empty());
    for (const auto& [asked, count] : symptom.failed) {
      EXPECT_LE(count, 40U);
      failed += count;
    }
  }
  EXPECT_EQ(failed, failures.failed);
  EXPECT_EQ(failures.asked.size(), 4U);
  for (const Asked& asked : failures.asked) {
    EXPECT_EQ(asked.oracle, "deep");
    EXPECT_EQ(asked.count, 40U);
    EXPECT_TRUE(asked.pair);
  }
  EXPECT_GT(failed, 80U);  // All of the deep ones.
}

TEST(Symptoms, TellCrashesApartAndPutThemFirst) {
  const FakeOracle crashing("crashing", [](const ContactQuery& query) {
    ContactAnswer answer = RightAnswer(query);
    if (!answer.touching) return answer;
    const Body& ball = KindOf(query.A.shape) == ShapeKind::kSphere ? query.A : query.B;
    // The same in every frame and at every scale.
    const double depth = -*answer.separation / std::get<Sphere>(ball.shape).radius;
    if (depth > 1) return CrashedAnswer("killed by SIGSEGV");
    if (depth > 0.3) return CrashedAnswer("threw std::logic_error: deep");
    *answer.separation *= 2;
    return answer;
  });
  const std::vector<Symptom> symptoms = FailuresOfASweep({&crashing}).symptoms;
  ASSERT_GE(symptoms.size(), 3U);
  EXPECT_NE(symptoms[0].key.ending, "");
  EXPECT_NE(symptoms[1].key.ending, "");
  EXPECT_NE(symptoms[0].key.ending, symptoms[1].key.ending);
  EXPECT_EQ(symptoms.back().key.ending, "");
}

TEST(Symptoms, TellAMissedContactFromAFalseOne) {
  const FakeOracle blind =
      FakeOracle::Wrong("blind", [](const ContactQuery&, ContactAnswer& answer) {
        answer.touching = !answer.touching;
      });
  int missed = 0;
  int invented = 0;
  for (const Symptom& symptom : FailuresOfASweep({&blind}).symptoms) {
    if (symptom.key.measure != MeasureKind::kTouching) continue;
    (symptom.key.touching ? missed : invented) += 1;
  }
  EXPECT_EQ(missed, 1);
  EXPECT_EQ(invented, 1);
}

// A report goes to strangers. A rate of questions that depend on the answers says
// nothing.
TEST(Asked, IsAFileWithoutItsFoldersOrASearchThatSaysSo) {
  const FakeOracle right("right");
  SweepPlan plan;
  plan.subjects = {&right};
  const auto questions =
      std::make_shared<const std::vector<Scenario>>(1, ScenarioAt(QuestionSeries{}, 0));
  for (const char* const file :
       {"/home/me/poses.csv", "/home/me/scenes/", "mine/a.toml"}) {
    plan.series.emplace_back(
        FileSeries{.file = file, .digest = "0", .count = 1, .questions = questions});
  }
  plan.series.emplace_back(QuestionSeries{.count = 4, .climb = 2});
  std::vector<std::string> what;
  for (const Asked& asked : FailuresOf(plan).asked) what.push_back(asked.what);
  EXPECT_EQ(what, (std::vector<std::string>{"the file poses.csv, box and box",
                                            "the file scenes, box and box",
                                            "the file mine/a.toml, box and box",
                                            "worst cases of random, box and box"}));
}

TEST(Symptoms, OfRightAnswersAreNone) {
  const FakeOracle right("right");
  const Failures failures = FailuresOfASweep({&right});
  EXPECT_TRUE(failures.symptoms.empty());
  EXPECT_EQ(failures.failed, 0U);
  EXPECT_EQ(failures.asked.size(), 4U);
}

}  // namespace
}  // namespace touchstone
