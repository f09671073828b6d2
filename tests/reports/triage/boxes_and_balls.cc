#include "tests/reports/triage/boxes_and_balls.h"

#include <map>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "reports/finding/ending.h"
#include "reports/shrink/shrink.h"
#include "reports/writers/outcome.h"

namespace touchstone {

Scenario BoxAnd(Shape B, const Eigen::Vector3d& p_WB) {
  // Moved in: GCC 12 warns of assigned literals here.
  Scenario scenario;
  scenario.id = std::string("mine/question");
  scenario.title = std::string("A box and another body");
  scenario.source = std::string("none");
  scenario.name_A = std::string("A");
  scenario.name_B = std::string("B");
  scenario.contact.A = {Box{{1, 1, 1}}, {}};
  scenario.contact.B = {std::move(B), Pose::FromQuaternion(p_WB, {1, 0, 0, 0})};
  return scenario;
}

Symptom SymptomIn(const Scenario& scenario, const Oracle& oracle) {
  const RunReport report = AskAlone(scenario, oracle);
  const std::vector<Outcome> outcomes = OutcomesOf(report);
  EXPECT_TRUE(IsFailure(outcomes.front().verdict));
  const Finding& finding = *outcomes.front().decisive;
  const std::string ending = EndingOf(finding);
  Symptom symptom;
  Symptom::Key& key = symptom.key;
  key.oracle = oracle.info().name;
  key.of = std::string("box and sphere");
  key.measure = finding.measure;
  key.verdict = finding.verdict;
  key.ending = ending;
  FailedQuestion& failure = symptom.kept.emplace_back();
  FindingKind& kind = failure.kind;
  kind.measure = finding.measure;
  kind.verdict = finding.verdict;
  kind.grade = finding.grade;
  kind.cause = finding.cause;
  kind.ending = ending;
  failure.scenario = TextOf(scenario);
  symptom.failed.emplace("random, box and sphere", 5);
  symptom.grades.emplace(finding.grade, 5);
  return symptom;
}

Specimen SmallestIn(const Scenario& scenario, const Oracle& oracle) {
  return Smallest(AskAgain(SymptomIn(scenario, oracle), oracle), {});
}

std::vector<Root> RootsAmongBoxesAndBalls(std::vector<Specimen> specimens) {
  std::map<std::string, const Oracle*> oracles;
  for (const Specimen& specimen : specimens) {
    if (specimen.oracle != nullptr)
      oracles.emplace(specimen.oracle->info().name, specimen.oracle);
  }
  std::vector<Asked> asked;
  std::vector<const Oracle*> subjects;
  for (const auto& [name, oracle] : oracles) {
    subjects.push_back(oracle);
    for (const char* const family : {"random", "deep"}) {
      asked.push_back({.oracle = name,
                       .what = fmt::format("{}, box and sphere", family),
                       .pair = {{ShapeKind::kBox, ShapeKind::kSphere}},
                       .count = 100});
    }
    asked.push_back({.oracle = name,
                     .what = std::string("random, box and cone"),
                     .pair = {{ShapeKind::kBox, ShapeKind::kCone}},
                     .count = 50});
  }
  return RootsOf(std::move(specimens), asked, subjects);
}

}  // namespace touchstone
