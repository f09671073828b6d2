#include "reports/contacts/grade.h"
#include "reports/run.h"
#include "reports/sweep/ask_block.h"
#include "reports/sweep/climb.h"
#include "reports/sweep/count_answer.h"
#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

std::vector<const Oracle*> SubjectAndReferences(const SweepPlan& plan,
                                                const Oracle* subject) {
  std::vector<const Oracle*> oracles = {subject};
  for (const Oracle* reference : plan.references) {
    if (reference != subject) oracles.push_back(reference);
  }
  return oracles;
}

}  // namespace

SeriesTally AskContacts(const SweepPlan& plan, const QuestionSeries& block,
                        std::optional<std::size_t> examined) {
  TrueQuestions questions;
  if (block.climb == 1) questions = QuestionsOf(block);
  TruthsOfNeighbours truths_of_neighbours;
  VariantsOfAll variants;
  SeriesTally tally;
  for (const Oracle* subject : plan.subjects) {
    if (block.climb > 1) {
      questions = ClimbOf(block, *subject);
      truths_of_neighbours.clear();
      variants.clear();
    }
    RunOptions options;
    options.jobs = 1;
    options.partial = true;
    options.reasons = Reasons::kNoneButProofs;
    options.truths = questions.truths;
    options.truths_of_neighbours = &truths_of_neighbours;
    options.variants = &variants;
    options.examined_per_kind = examined;
    const std::vector<const Oracle*> oracles = SubjectAndReferences(plan, subject);
    const RunReport report = Run(questions.scenarios, oracles, {}, options);
    const std::vector<Outcome> outcomes = OutcomesOf(report);
    OracleTally& of_subject = tally.oracles.emplace_back();
    for (std::uint64_t i = 0; i < block.count; ++i) {
      // Ids sort as indices do, so the report has the order of the block.
      const ScenarioResult& result = report.scenarios[i];
      CountAnswer({.question = block.first + i,
                   .outcome = outcomes[i * oracles.size()],
                   .touching = result.truth.touching == Touching::kTouching,
                   .undecided = result.truth.touching == Touching::kUndecided,
                   .share_of =
                       [&result](const Finding& finding) {
                         return ShareOf(finding, result.scenario.contact, result.truth);
                       },
                   .write = [&result] { return WriteScenario(result.scenario); }},
                  of_subject);
    }
  }
  return tally;
}

}  // namespace touchstone
