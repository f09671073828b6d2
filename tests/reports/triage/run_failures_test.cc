#include "reports/triage/run_failures.h"

#include <gtest/gtest.h>

#include "scenarios/scenario_file.h"
#include "tests/reports/fake_oracle.h"
#include "tests/reports/triage/boxes_and_balls.h"

namespace touchstone {
namespace {

/** Returns a run in which two oracles were asked about a ball and about a box, and `deep`
 has a verdict on the ball. */
ReadReportData RunWith(Verdict verdict) {
  ReadReportData run;
  run.oracles = {{"deep", "1.0"}, {"right", "1.0"}};
  int i = 0;
  for (const Shape& shape : {Shape(Sphere{0.5}), Shape(Box{{0.5, 0.5, 0.5}})}) {
    Scenario scenario = BoxAnd(shape, {1.3, 0.1, 0.2});
    scenario.id += std::to_string(i);
    for (const auto& [oracle, version] : run.oracles) {
      run.baseline.Add({scenario.id, oracle, MeasureKind::kTouching, ""}, {});
      if (i == 0 && oracle == "deep") {
        run.baseline.Add({scenario.id, oracle, MeasureKind::kSeparationError, ""},
                         {.value = 0.2, .verdict = verdict});
      }
    }
    run.questions.emplace(scenario.id, WriteScenario(scenario));
    ++i;
  }
  return run;
}

const FakeOracle kDeep =
    FakeOracle::Wrong("deep", [](const ContactQuery&, ContactAnswer& answer) {
      if (answer.separation) *answer.separation -= 0.2;
    });

TEST(RunFailures, AreTheAnswersThatFailAgain) {
  const RunQuestions run = QuestionsOf(RunWith(Verdict::kFail), {"deep", "right"});
  ASSERT_EQ(run.failed.size(), 1U);
  EXPECT_EQ(run.failed[0].oracle, "deep");
  EXPECT_EQ(IdOf(run.failed[0].question), "mine/question0");
  ASSERT_EQ(run.asked.size(), 4U);  // Two pairs for each of two oracles.
  for (const Asked& asked : run.asked) EXPECT_EQ(asked.count, 1U);

  const std::vector<std::optional<OracleTally>> again = {AskAgain(run.failed[0], kDeep)};
  const Failures failures = FailuresOf(run, again);
  EXPECT_EQ(failures.failed, 1U);
  EXPECT_EQ(failures.vanished, 0U);
  ASSERT_EQ(failures.symptoms.size(), 1U);
  const Symptom& symptom = failures.symptoms[0];
  EXPECT_EQ(symptom.key.of, "box and sphere");
  EXPECT_TRUE(symptom.key.touching);
  EXPECT_EQ(symptom.failed.at("box and sphere"), 1U);
  EXPECT_GT(symptom.kept.at(0).share, 0.01);
  EXPECT_TRUE(AskAgain(symptom, kDeep).is_repeatable);
}

TEST(RunFailures, ThatDoNotFailAgainAreCounted) {
  const RunQuestions run = QuestionsOf(RunWith(Verdict::kFail), {"deep"});
  const FakeOracle mended("deep");
  const Failures failures = FailuresOf(
      run, std::vector<std::optional<OracleTally>>{AskAgain(run.failed.at(0), mended)});
  EXPECT_TRUE(failures.symptoms.empty());
  EXPECT_EQ(failures.vanished, 1U);
  EXPECT_EQ(failures.asked.size(), 2U);
}

TEST(RunFailures, AreThoseOfTheMeasuresThatFailed) {
  // The ledger knows its depth, and not that its contacts are aside.
  const FakeOracle two =
      FakeOracle::Wrong("deep", [](const ContactQuery&, ContactAnswer& answer) {
        *answer.separation -= 0.2;
        for (ContactPoint& point : answer.points) point.p_WC.x() += 5;
      });
  FailedAnswer answer = QuestionsOf(RunWith(Verdict::kFail), {"deep"}).failed.at(0);
  const auto measure_of = [&](MeasureKind failed) {
    answer.cells = {{failed, ""}};
    const OracleTally tally = AskAgain(answer, two);
    EXPECT_EQ(tally.failures.size(), 1U);
    return tally.failures.begin()->first.measure;
  };
  for (const MeasureKind failed :
       {MeasureKind::kSeparationError, MeasureKind::kContactSurfaceError})
    EXPECT_EQ(measure_of(failed), failed);
}

TEST(RunFailures, ForWhichThereWasNoTimeAreCountedApart) {
  const RunQuestions run = QuestionsOf(RunWith(Verdict::kFail), {"deep"});
  const Failures failures =
      FailuresOf(run, std::vector<std::optional<OracleTally>>{std::nullopt});
  EXPECT_EQ(failures.unasked, 1U);
  EXPECT_EQ(failures.vanished, 0U);
}

TEST(RunFailures, AreNotThoseThatTheLedgerKnowsOrThatNobodyProved) {
  for (const Verdict verdict :
       {Verdict::kKnown, Verdict::kDisagree, Verdict::kUndecidable, Verdict::kPass}) {
    EXPECT_TRUE(QuestionsOf(RunWith(verdict), {"deep", "right"}).failed.empty());
  }
  EXPECT_TRUE(QuestionsOf(RunWith(Verdict::kFail), {"right"}).failed.empty());
}

TEST(RunFailures, RefuseAQuestionThatCannotBeRead) {
  ReadReportData run = RunWith(Verdict::kFail);
  run.questions.begin()->second = std::string("shape = ");
  EXPECT_THROW(QuestionsOf(run, {"deep"}), UnreadableQuestion);
  run.questions.clear();
  EXPECT_THROW(QuestionsOf(run, {"deep"}), UnreadableQuestion);
}

}  // namespace
}  // namespace touchstone
