#include "reports/triage/symptom.h"

#include <gtest/gtest.h>

#include "oracles/no_answer.h"
#include "reports/sweep/sweep.h"
#include "tests/reports/fake_oracle.h"

namespace touchstone {
namespace {

/** Returns the symptoms of a sweep over spheres and boxes in both orders. */
std::vector<Symptom> SymptomsOfASweep(const std::vector<const Oracle*>& subjects) {
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
  return SymptomsOf(file);
}

TEST(Symptoms, JoinFamiliesAndBothOrdersOfAPair) {
  const FakeOracle deep =
      FakeOracle::Wrong("deep", [](const ContactQuery&, ContactAnswer& answer) {
        if (answer.separation && answer.touching) *answer.separation *= 2;
      });
  const std::vector<Symptom> symptoms = SymptomsOfASweep({&deep});
  ASSERT_FALSE(symptoms.empty());
  std::uint64_t failed = 0;
  for (const Symptom& symptom : symptoms) {
    EXPECT_EQ(symptom.key.oracle, "deep");
    EXPECT_EQ(symptom.key.of, "box, sphere");
    EXPECT_FALSE(symptom.kept.empty());
    for (const auto& [asked, rate] : symptom.rates) {
      EXPECT_EQ(rate.asked, 40U);
      EXPECT_LE(rate.failed, 40U);
      failed += rate.failed;
    }
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
  const std::vector<Symptom> symptoms = SymptomsOfASweep({&crashing});
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
  for (const Symptom& symptom : SymptomsOfASweep({&blind})) {
    if (symptom.key.measure != MeasureKind::kTouching) continue;
    (symptom.key.touching ? missed : invented) += 1;
  }
  EXPECT_EQ(missed, 1);
  EXPECT_EQ(invented, 1);
}

TEST(Symptoms, OfRightAnswersAreNone) {
  const FakeOracle right("right");
  EXPECT_TRUE(SymptomsOfASweep({&right}).empty());
}

}  // namespace
}  // namespace touchstone
