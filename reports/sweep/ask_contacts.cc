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

/** Questions that are put to one subject after the other, and what the next one need not
 compute again. */
struct AskedQuestions {
  TrueQuestions questions;
  TruthsOfNeighbours truths_of_neighbours = {};
  VariantsOfAll variants = {};
};

/** Puts the questions to `subject` and counts its answers. `first` is the index of the
 first question in its series. Empty if it was stopped. */
std::optional<OracleTally> Ask(const SweepPlan& plan, const Oracle* subject,
                               std::uint64_t first, std::optional<std::size_t> examined,
                               const Stop& stop, AskedQuestions& asked) {
  RunOptions options;
  options.jobs = 1;
  options.partial = true;
  options.reasons = Reasons::kNoneButProofs;
  options.truths = asked.questions.truths;
  options.truths_of_neighbours = &asked.truths_of_neighbours;
  options.variants = &asked.variants;
  options.examined_per_kind = examined;
  options.stop = stop;
  const std::vector<const Oracle*> oracles = SubjectAndReferences(plan, subject);
  const RunReport report = Run(asked.questions.scenarios, oracles, {}, options);
  if (IsStopped(stop)) return std::nullopt;
  const std::vector<Outcome> outcomes = OutcomesOf(report);
  OracleTally tally;
  for (std::size_t i = 0; i < asked.questions.scenarios.size(); ++i) {
    // Ids sort as indices do, so the report has the order of the block.
    const ScenarioResult& result = report.scenarios[i];
    CountAnswer({.question = first + i,
                 .outcome = outcomes[i * oracles.size()],
                 .touching = result.truth.touching == Touching::kTouching,
                 .undecided = result.truth.touching == Touching::kUndecided,
                 .share_of =
                     [&result](const Finding& finding) {
                       return ShareOf(finding, result.scenario.contact, result.truth);
                     },
                 .write = [&result] { return WriteScenario(result.scenario); }},
                tally);
  }
  return tally;
}

/** Puts the same questions to every subject. */
std::optional<SeriesTally> AskAll(const SweepPlan& plan, std::uint64_t first,
                                  std::optional<std::size_t> examined, const Stop& stop,
                                  AskedQuestions asked) {
  SeriesTally tally;
  for (const Oracle* subject : plan.subjects) {
    auto of_subject = Ask(plan, subject, first, examined, stop, asked);
    if (!of_subject) return std::nullopt;
    tally.oracles.push_back(std::move(*of_subject));
  }
  return tally;
}

}  // namespace

std::optional<SeriesTally> AskContacts(const SweepPlan& plan, const QuestionSeries& block,
                                       std::optional<std::size_t> examined,
                                       const Stop& stop) {
  if (block.climb == 1) {
    return AskAll(plan, block.first, examined, stop,
                  {.questions = QuestionsOf(block, stop)});
  }
  SeriesTally tally;
  for (const Oracle* subject : plan.subjects) {
    AskedQuestions asked{.questions = ClimbOf(block, *subject, stop)};
    auto of_subject = Ask(plan, subject, block.first, examined, stop, asked);
    if (!of_subject) return std::nullopt;
    tally.oracles.push_back(std::move(*of_subject));
  }
  return tally;
}

std::optional<SeriesTally> AskContacts(const SweepPlan& plan, const FileSeries& block,
                                       std::optional<std::size_t> examined,
                                       const Stop& stop) {
  return AskAll(plan, block.first, examined, stop,
                {.questions = QuestionsOf(block, stop)});
}

}  // namespace touchstone
