#include "reports/triage/run_failures.h"

#include <map>
#include <utility>

#include <fmt/format.h>

#include "reports/clusters/shares.h"
#include "reports/finding/decisive.h"
#include "reports/shrink/shrink.h"
#include "reports/sweep/count_answer.h"
#include "reports/writers/outcome.h"
#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

Question QuestionIn(const std::string& id, const std::string& text) {
  ReadResult read = ReadScenario(text, id);
  if (read.world) return std::move(*read.world);
  if (read.scenario) return std::move(*read.scenario);
  throw UnreadableQuestion(
      fmt::format("{}; expected the report of a run by this version of Touchstone",
                  ToString(read.diagnostics.front())));
}

/** Returns Symptom::Key::of the question. */
std::string SubjectOf(const Question& question) {
  const auto* const scenario = std::get_if<Scenario>(&question);
  if (scenario == nullptr) return "worlds";
  return PairName(KindOf(scenario->contact.A.shape), KindOf(scenario->contact.B.shape));
}

/** Returns Asked::what and Asked::pair of the question. */
Asked AskedOf(const Question& question) {
  const auto* const scenario = std::get_if<Scenario>(&question);
  if (scenario == nullptr) return {.oracle = {}, .what = "worlds", .pair = {}};
  const std::pair pair(KindOf(scenario->contact.A.shape),
                       KindOf(scenario->contact.B.shape));
  return {.oracle = {},
          .what = fmt::format("{} and {}", NameOf(pair.first), NameOf(pair.second)),
          .pair = pair};
}

}  // namespace

RunQuestions QuestionsOf(const ReadReportData& run,
                         const std::set<std::string>& oracles) {
  std::map<std::pair<std::string, std::string>,
           std::set<std::pair<MeasureKind, std::string>>>
      failed;
  std::set<std::pair<std::string, std::string>> answered;
  for (const auto& [cell, measured] : run.baseline.cells) {
    if (measured.verdict != Verdict::kUnsupported)
      answered.emplace(cell.scenario, cell.oracle);
    if (IsFault(measured.verdict))
      failed[{cell.scenario, cell.oracle}].emplace(cell.measure, cell.law);
  }
  for (const auto& [answer, cells] : failed) {
    const std::string& scenario = answer.first;
    if (run.questions.contains(scenario)) continue;
    throw UnreadableQuestion(fmt::format(
        "the report has no text of {}; expected one of `touchstone run --out` "
        "of this version",
        scenario));
  }
  RunQuestions questions;
  std::map<std::pair<std::string, std::string>, Asked> asked;
  for (const auto& [id, text] : run.questions) {
    const Question question = QuestionIn(id, text);
    Asked row = AskedOf(question);
    for (const std::string& oracle : oracles) {
      if (!answered.contains({id, oracle})) continue;
      row.oracle = oracle;
      ++asked.try_emplace({oracle, row.what}, row).first->second.count;
      const auto cells = failed.find({id, oracle});
      if (cells != failed.end())
        questions.failed.push_back({question, oracle, cells->second});
    }
  }
  for (auto& [of, row] : asked) questions.asked.push_back(std::move(row));
  return questions;
}

OracleTally AskAgain(const FailedAnswer& answer, const Oracle& oracle) {
  const RunReport report = AskAlone(answer.question, oracle);
  const std::vector<double> shares = SharesOf(report, PlacesOf(report));
  bool touching = false;
  bool undecided = false;
  if (!report.scenarios.empty()) {
    touching = report.scenarios.front().truth.touching == Touching::kTouching;
    undecided = report.scenarios.front().truth.touching == Touching::kUndecided;
  }
  std::vector<Finding> faults;
  std::vector<double> shares_of_faults;
  for (std::size_t i = 0; i < report.findings.size(); ++i) {
    const Finding& finding = report.findings[i];
    if (!IsFault(finding.verdict) ||
        !answer.cells.contains({finding.measure, finding.law}))
      continue;
    faults.push_back(finding);
    shares_of_faults.push_back(shares[i]);
  }
  Outcome outcome{.scenario = 0, .oracle = 0, .findings = faults};
  outcome.decisive = DecisiveOf(faults);
  outcome.verdict =
      outcome.decisive == nullptr ? Verdict::kPass : outcome.decisive->verdict;
  OracleTally tally;
  CountAnswer(
      {.question = 0,
       .outcome = outcome,
       .touching = touching,
       .undecided = undecided,
       .share_of =
           [&](const Finding& finding) {
             return shares_of_faults[static_cast<std::size_t>(&finding - faults.data())];
           },
       .write = [&] { return TextOf(answer.question); }},
      tally);
  return tally;
}

Failures FailuresOf(const RunQuestions& run,
                    std::span<const std::optional<OracleTally>> again) {
  Failures failures{.symptoms = {}, .asked = run.asked};
  Symptoms symptoms;
  for (std::size_t i = 0; i < run.failed.size(); ++i) {
    if (!again[i]) {
      ++failures.unasked;
      continue;
    }
    const Question& question = run.failed[i].question;
    AddAnswers(*again[i], run.failed[i].oracle, SubjectOf(question),
               AskedOf(question).what, symptoms, failures);
    if (again[i]->failures.empty()) ++failures.vanished;
  }
  failures.symptoms = GravestFirst(symptoms);
  return failures;
}

}  // namespace touchstone
