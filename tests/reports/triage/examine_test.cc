#include "reports/triage/examine.h"

#include <atomic>

#include <gtest/gtest.h>

#include "oracles/no_answer.h"
#include "reports/shrink/size.h"
#include "tests/reports/fake_oracle.h"
#include "tests/reports/triage/boxes_and_balls.h"

namespace touchstone {
namespace {

TEST(Specimen, ShrinksTheGravestQuestion) {
  const FakeOracle oracle =
      FakeOracle::Wrong("wrong", [](const ContactQuery&, ContactAnswer& answer) {
        if (answer.touching && answer.separation) *answer.separation *= 2;
      });
  const Scenario question = BoxAnd(Sphere{0.51234}, {1.23456, 0.1234, 0.2345});
  const Specimen specimen = SmallestIn(question, oracle);
  ASSERT_TRUE(specimen.is_repeatable);
  EXPECT_LT(SizeOf(specimen.question), SizeOf(question));
  EXPECT_EQ(specimen.finding.verdict, Verdict::kFail);
  EXPECT_GE(specimen.shifts.value(), 10U);
}

// The answer to the question is right, and that to its swapped variant is wrong.
TEST(Specimen, TakesAWrongVariantForTheQuestion) {
  const FakeOracle oracle =
      FakeOracle::Wrong("wrong", [](const ContactQuery& query, ContactAnswer& answer) {
        if (KindOf(query.A.shape) == ShapeKind::kSphere && answer.separation)
          *answer.separation -= 0.1;
      });
  const Scenario question = BoxAnd(Sphere{0.5}, {1.3, 0.1, 0.2});
  const Symptom symptom = SymptomIn(question, oracle);
  EXPECT_EQ(symptom.key.measure, MeasureKind::kSwap);
  const Specimen specimen = AskAgain(symptom, oracle);
  ASSERT_TRUE(specimen.is_repeatable);
  EXPECT_EQ(specimen.finding.measure, MeasureKind::kSeparationError);
  EXPECT_EQ(KindOf(std::get<Scenario>(specimen.question).contact.A.shape),
            ShapeKind::kSphere);
}

// The answer to the question is wrong, too, but a crash of its variant is another root.
TEST(Specimen, TakesTheCrashOfAVariantRatherThanAFaultOfTheAnswer) {
  const FakeOracle oracle("wrong", [](const ContactQuery& query) {
    if (KindOf(query.A.shape) == ShapeKind::kSphere)
      return CrashedAnswer("killed by SIGSEGV");
    ContactAnswer answer = RightAnswer(query);
    *answer.separation -= 0.1;
    return answer;
  });
  const Scenario question = BoxAnd(Sphere{0.5}, {1.3, 0.1, 0.2});
  const Symptom symptom = SymptomIn(question, oracle);
  EXPECT_EQ(symptom.key.measure, MeasureKind::kSwap);
  const Specimen specimen = AskAgain(symptom, oracle);
  ASSERT_TRUE(specimen.is_repeatable);
  EXPECT_EQ(specimen.finding.measure, MeasureKind::kAnswering);
  EXPECT_EQ(specimen.finding.verdict, Verdict::kCrashed);
}

TEST(Specimen, FindsThatAnAnswerIsNotRepeated) {
  std::atomic<bool> is_wrong = true;
  const FakeOracle oracle =
      FakeOracle::Wrong("wrong", [&](const ContactQuery&, ContactAnswer& answer) {
        if (is_wrong && answer.separation) *answer.separation -= 0.1;
      });
  const Scenario question = BoxAnd(Sphere{0.5}, {1.3, 0.1, 0.2});
  const Symptom symptom = SymptomIn(question, oracle);
  is_wrong = false;
  EXPECT_FALSE(AskAgain(symptom, oracle).is_repeatable);
}

}  // namespace
}  // namespace touchstone
