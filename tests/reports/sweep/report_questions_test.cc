#include "reports/sweep/report_questions.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "reports/run.h"
#include "reports/sweep/question_series.h"
#include "reports/writers/json_writer.h"
#include "scenarios/scenario_file.h"
#include "tests/reports/sweep/spheres.h"

namespace touchstone {
namespace {

class ReportQuestionsTest : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }

  /** Returns the error of a report with that text, without the name of the file. */
  std::string ErrorOf(const std::string& text) const {
    std::ofstream(file_) << text;
    const ReportQuestions read = ReadReportQuestions(file_);
    EXPECT_EQ(read.error.has_value(), read.scenarios.empty());
    return read.error ? ToString(*read.error).substr(file_.string().size()) : "";
  }

  const std::filesystem::path file_ =
      std::filesystem::path(testing::TempDir()) /
      ("report_questions_test_" + std::to_string(getpid()) + ".jsonl");
};

TEST_F(ReportQuestionsTest, AreThoseOfTheRunBitForBit) {
  std::vector<Scenario> scenarios;
  for (int a = 0; a < kShapeKinds; ++a) {
    QuestionSeries series{.family = Family::kExtremeScales};
    series.A = static_cast<ShapeKind>(a);
    series.B = ShapeKind::kSphere;
    scenarios.push_back(ScenarioAt(series, 7));
    scenarios.back().title += "\"quoted\" π \\ \t";
    Pose& pose = scenarios.back().contact.A.X_WB;
    // A matrix instead of a quaternion.
    if (a % 2 == 0) pose = Pose::FromMatrix(pose.p_WB, pose.R_WB);
  }
  scenarios.front().tolerance = {2.5e-3, "its author \"grants\" it"};
  const auto oracle = Spheres("right", 1);
  const Oracle* const oracles[] = {oracle.get()};
  RunOptions options;
  options.partial = true;
  const RunReport report = touchstone::Run(scenarios, oracles, {}, options);
  {
    std::ofstream out(file_);
    WriteJson(report, out);
  }
  const ReportQuestions read = ReadReportQuestions(file_);
  ASSERT_FALSE(read.error) << ToString(*read.error);
  ASSERT_EQ(read.scenarios.size(), report.scenarios.size());
  for (std::size_t i = 0; i < read.scenarios.size(); ++i)
    EXPECT_EQ(WriteScenario(read.scenarios[i]),
              WriteScenario(report.scenarios[i].scenario));
}

TEST_F(ReportQuestionsTest, AreRefusedWithTheLineAtFault) {
  EXPECT_EQ(ErrorOf("{\"kind\":\"run\"}\n"),
            ": has no contact question; expected a report.jsonl that `touchstone run "
            "--out` wrote");
  for (const char* line : {"{", "[]", "{}", "{\"kind\":\"scenario\"}"}) {
    EXPECT_EQ(ErrorOf(std::string("{\"kind\":\"run\"}\n") + line),
              ":2:1: is no line of a report; expected a report.jsonl that `touchstone "
              "run --out` wrote");
  }
  EXPECT_EQ(ErrorOf(R"({"kind":"scenario","id":"a","title":"b","source":"c",)"
                    R"("A":{"shape":"sphere","radius":-1,"position":[0,0,0],)"
                    R"("quaternion_wxyz":[1,0,0,0]},"B":{"shape":"half_space",)"
                    R"("position":[0,0,0],"rotation":[[1,0,0],[0,1,0],[0,0,1]]}})"),
            ":1:1: bodies.A.radius is -1; expected a finite length > 0");
}

}  // namespace
}  // namespace touchstone
