#include "reports/sweep/ask_block.h"

#include <cmath>
#include <limits>
#include <span>

#include "reports/contacts/grade.h"
#include "reports/run.h"
#include "reports/sweep/climb.h"
#include "reports/writers/outcome.h"
#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

FindingKind KindOf(const Finding& finding) {
  return {finding.measure, finding.verdict, finding.grade, finding.cause};
}

/** Returns `share` such that it can be ordered. */
double Ordered(double share) {
  return std::isnan(share) ? std::numeric_limits<double>::infinity() : share;
}

void AddFinding(const Finding& finding, const ScenarioResult& result,
                std::uint64_t question, OracleTally& tally) {
  ++tally.findings[KindOf(finding)];
  // A measure that proves nothing is neither among the values nor among the worst.
  if (finding.verdict == Verdict::kUndecidable ||
      finding.verdict == Verdict::kUnsupported) {
    return;
  }
  tally.sketches[finding.measure].Add(finding.value);
  Insert({.question = question,
          .value = finding.value,
          .tolerance = finding.tolerance,
          .tolerances = RelativeToTolerance(finding),
          .share = Ordered(ShareOf(finding, result.scenario.contact, result.truth)),
          .verdict = finding.verdict},
         tally.worst[finding.measure]);
}

void AddAnswer(const Outcome& outcome, const ScenarioResult& result,
               std::uint64_t question, OracleTally& tally) {
  ++tally.asked;
  if (result.truth.touching == Touching::kTouching) ++tally.touching;
  if (result.truth.touching == Touching::kUndecided) ++tally.undecided;
  for (const Finding& finding : outcome.findings)
    AddFinding(finding, result, question, tally);
  if (IsVerified(outcome.findings)) {
    ++tally.verified;
    if (result.truth.touching == Touching::kTouching) ++tally.verified_touching;
  }
  if (outcome.decisive == nullptr) return;
  const Finding& decisive = *outcome.decisive;
  FindingKind kind = KindOf(decisive);
  kind.verdict = outcome.verdict;
  ++tally.answers[kind];
  if (!IsFailure(outcome.verdict)) return;
  std::vector<FailedQuestion>& of_kind = tally.failures[{kind.measure, kind.cause}];
  if (!IsKept(question, of_kind)) return;
  Insert(FailedQuestion{.question = question,
                        .kind = kind,
                        .value = decisive.value,
                        .tolerance = decisive.tolerance,
                        .share = Ordered(
                            ShareOf(decisive, result.scenario.contact, result.truth)),
                        .proof = decisive.proof,
                        .scenario = WriteScenario(result.scenario)},
         of_kind);
}

std::vector<const Oracle*> SubjectAndReferences(const SweepPlan& plan,
                                                const Oracle* subject) {
  std::vector<const Oracle*> oracles = {subject};
  for (const Oracle* reference : plan.references) {
    if (reference != subject) oracles.push_back(reference);
  }
  return oracles;
}

}  // namespace

SeriesTally AskBlock(const SweepPlan& plan, const QuestionSeries& block) {
  TrueQuestions questions;
  if (block.climb == 1) questions = QuestionsOf(block);
  SeriesTally tally;
  for (const Oracle* subject : plan.subjects) {
    if (block.climb > 1) questions = ClimbOf(block, *subject);
    RunOptions options;
    options.jobs = 1;
    options.partial = true;
    options.truths = questions.truths;
    const std::vector<const Oracle*> oracles = SubjectAndReferences(plan, subject);
    const RunReport report = Run(questions.scenarios, oracles, {}, options);
    const std::vector<Outcome> outcomes = OutcomesOf(report);
    OracleTally& of_subject = tally.oracles.emplace_back();
    for (std::uint64_t i = 0; i < block.count; ++i) {
      // Ids sort as indices do, so the report has the order of the block.
      AddAnswer(outcomes[i * oracles.size()], report.scenarios[i], block.first + i,
                of_subject);
    }
  }
  return tally;
}

}  // namespace touchstone
