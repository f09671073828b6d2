#include "reports/triage/sweep_failures.h"

#include <set>

#include <gtest/gtest.h>

#include "oracles/no_answer.h"
#include "reports/sweep/sweep.h"
#include "tests/reports/fake_oracle.h"

namespace touchstone {
namespace {

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
  SweepFile file = SweepFile::Create(":memory:", SettingsOf(plan), SweepJournal::kNone);
  Sweep(plan, file, {});
  std::set<std::string> names;
  for (const Oracle* const oracle : subjects) names.insert(oracle->info().name);
  return FailuresOf(file, names);
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

TEST(Symptoms, OfRightAnswersAreNone) {
  const FakeOracle right("right");
  const Failures failures = FailuresOfASweep({&right});
  EXPECT_TRUE(failures.symptoms.empty());
  EXPECT_EQ(failures.failed, 0U);
  EXPECT_EQ(failures.asked.size(), 4U);
}

}  // namespace
}  // namespace touchstone
