#include "reports/gtest/contact_complaint.h"

#include <optional>
#include <sstream>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "reports/run.h"
#include "reports/shrink/shrink.h"
#include "reports/shrink/shrunk_file.h"
#include "reports/sweep/run_blocks.h"
#include "reports/text/counted.h"
#include "reports/writers/explanation_writer.h"
#include "reports/writers/outcome.h"
#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

/** Returns whether no answer of the tally is to a question that the oracle supports. */
bool IsUnsupported(const OracleTally& tally) {
  for (const auto& [kind, count] : tally.answers) {
    if (kind.verdict != Verdict::kUnsupported) return false;
  }
  return true;
}

/** The questions that are asked at most to make a failed one smaller: a second of work.
 */
constexpr std::size_t kTries = 400;

/** Returns a smaller question with the same fault; nothing if there is none, and if the
 answer is missing or invalid, as asking again could end the program. */
std::optional<Shrunk> ShrunkFor(const Scenario& scenario, const Oracle& subject) {
  const RunReport report = AskAlone(scenario, subject);
  const std::vector<Outcome> outcomes = OutcomesOf(report);
  if (outcomes.front().verdict != Verdict::kFail) return std::nullopt;
  Shrunk shrunk =
      Shrink(scenario, subject, *outcomes.front().decisive, {.tries = kTries});
  if (shrunk.accepted == 0) return std::nullopt;
  return shrunk;
}

}  // namespace

std::string ComplaintAbout(const Oracle& subject, const QuestionSeries& series,
                           std::span<const Oracle* const> references) {
  const SweepPlan plan{.series = {series},
                       .subjects = {&subject},
                       .references = {references.begin(), references.end()}};
  SeriesTally sum;
  RunBlocks(plan, {},
            [&sum](std::uint64_t, const SeriesTally& result) { Merge(result, sum); });
  sum.oracles.resize(1);
  const OracleTally& tally = sum.oracles.front();
  const std::string& name = subject.info().name;
  const std::string questions = fmt::format(
      "{} of the family {} ({} and {}, seed {})", Counted(tally.asked, "question"),
      NameOf(series.family), NameOf(series.A), NameOf(series.B), series.seed);
  if (IsUnsupported(tally)) {
    return fmt::format("{} supports none of {}: nothing was verified", name, questions);
  }
  if (tally.touching == 0) {
    return fmt::format("none of {} touched: nothing was verified", questions);
  }
  const FailedQuestion* const gravest = GravestFailure(tally);
  if (gravest == nullptr) return "";

  const Scenario scenario =
      ReadScenario(gravest->scenario, "the failed question").scenario.value();
  const std::optional<Shrunk> shrunk = ShrunkFor(scenario, subject);
  Scenario shown = scenario;
  if (shrunk) {
    shown = std::get<Scenario>(ScenarioOf(*shrunk, scenario));
    shown.indicts.clear();  // No other program knows the subject.
  }
  std::vector<const Oracle*> oracles = {&subject};
  oracles.insert(oracles.end(), references.begin(), references.end());
  RunOptions options;
  options.partial = true;
  std::ostringstream text;
  text << fmt::format(
      "{} is wrong in {} of {}; {} of them touching. The gravest{}:\n\n", name,
      FailureCount(tally), questions, tally.touching,
      shrunk ? fmt::format(", shrunk ({} asked, {} kept)",
                           Counted(shrunk->tried, "smaller question"), shrunk->accepted)
             : "");
  WriteExplanation(Run({&shown, 1}, oracles, {}, options), {}, text);
  text << "\nThe question, as a file for `touchstone run`:\n\n" << WriteScenario(shown);
  if (shrunk) text << "\nBefore it was shrunk:\n\n" << gravest->scenario;
  text << "\nTo ask the other oracles: " << ReplayOf(series, gravest->question) << '\n';
  return text.str();
}

}  // namespace touchstone
