#include "reports/sweep/sweep.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "reports/run.h"
#include "reports/text/counted.h"
#include "reports/writers/explanation_writer.h"
#include "reports/writers/outcome.h"
#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

// The number of questions per run: only one chunk is in memory at a time, and it keeps
// the threads busy.
constexpr std::uint64_t kChunk = 4096;

RunReport OnlyScenario(const RunReport& report, const Outcome& subject) {
  RunReport only;
  only.subject = report.subject;
  only.oracles = report.oracles;
  only.scenarios = {report.scenarios[subject.scenario]};
  const std::string& id = only.scenarios[0].scenario.id;
  std::copy_if(report.findings.begin(), report.findings.end(),
               std::back_inserter(only.findings),
               [&](const Finding& finding) { return finding.scenario == id; });
  return only;
}

void Add(const RunReport& report, const Outcome& subject, std::uint64_t index,
         std::size_t failures_kept, SweepResult& result) {
  ++result.asked;
  const ContactTruth& truth = report.scenarios[subject.scenario].truth;
  if (truth.touching == Touching::kTouching) ++result.touching;
  if (truth.touching == Touching::kUndecided) ++result.undecided;
  if (subject.verdict == Verdict::kUnsupported) ++result.unsupported;
  for (const Finding& finding : subject.findings) {
    // A measure that proves nothing is not among the worst.
    if (finding.verdict == Verdict::kUndecidable ||
        finding.verdict == Verdict::kUnsupported) {
      continue;
    }
    auto& worst = result.worst[static_cast<std::size_t>(finding.measure)];
    const double relative = RelativeToTolerance(finding);
    if (!worst || relative > worst->relative) {
      worst = WorstMeasure{relative, finding.value, index};
    }
  }
  if (!IsFailure(subject.verdict)) return;
  ++result.failed;
  if (result.first_failures.size() < failures_kept) {
    result.first_failures.push_back({index, OnlyScenario(report, subject)});
  }
}

}  // namespace

Scenario ScenarioAt(const QuestionSeries& series, std::uint64_t index) {
  Scenario scenario;
  // Indices have equal width, so that ids sort as indices do.
  scenario.id = fmt::format("sweep/{}/{}_{}/seed_{}/{:020}", NameOf(series.family),
                            NameOf(series.A), NameOf(series.B), series.seed, index);
  scenario.title =
      fmt::format("Question {} of the family {}, {} and {}, seed {}", index,
                  NameOf(series.family), NameOf(series.A), NameOf(series.B), series.seed);
  scenario.source = ReplayOf(series, index);
  scenario.name_A = 'A';
  scenario.name_B = 'B';
  scenario.contact = Generate(series.family, series.A, series.B, series.seed, index);
  return scenario;
}

std::string ReplayOf(const QuestionSeries& series, std::uint64_t index) {
  return fmt::format(
      "touchstone sweep contact --family {} --pair {} {} --seed {} --first {} --count 1",
      NameOf(series.family), NameOf(series.A), NameOf(series.B), series.seed, index);
}

SweepResult Sweep(const QuestionSeries& series, std::span<const Oracle* const> oracles,
                  const SweepOptions& options) {
  SweepResult result;
  RunOptions run;
  run.jobs = options.jobs;
  run.partial = true;
  for (std::uint64_t done = 0; done < series.count;) {
    const std::uint64_t size = std::min(kChunk, series.count - done);
    std::vector<Scenario> scenarios;
    for (std::uint64_t i = 0; i < size; ++i) {
      scenarios.push_back(ScenarioAt(series, series.first + done + i));
    }
    const RunReport report = Run(scenarios, oracles, {}, run);
    const std::vector<Outcome> outcomes = OutcomesOf(report);
    for (std::uint64_t i = 0; i < size; ++i) {
      Add(report, outcomes[i * oracles.size()], series.first + done + i,
          options.failures_kept, result);
    }
    done += size;
    if (options.on_progress) options.on_progress(done, series.count);
  }
  return result;
}

std::string ComplaintAbout(const Oracle& subject, const QuestionSeries& series,
                           std::span<const Oracle* const> references) {
  std::vector<const Oracle*> oracles = {&subject};
  oracles.insert(oracles.end(), references.begin(), references.end());
  const SweepResult result = Sweep(series, oracles, {.failures_kept = 1});
  const std::string& name = subject.info().name;
  const std::string questions = fmt::format(
      "{} of the family {} ({} and {}, seed {})", Counted(result.asked, "question"),
      NameOf(series.family), NameOf(series.A), NameOf(series.B), series.seed);
  if (result.unsupported == result.asked) {
    return fmt::format("{} supports none of {}: nothing was verified", name, questions);
  }
  if (result.touching == 0) {
    return fmt::format("none of {} touched: nothing was verified", questions);
  }
  if (result.failed == 0) return "";

  const FailedQuestion& first = result.first_failures.front();
  std::ostringstream text;
  text << fmt::format("{} is wrong in {} of {}; {} of them touching. The first:\n\n",
                      name, result.failed, questions, result.touching);
  WriteExplanation(first.report, {}, text);
  text << "\nThe question, as a file for `touchstone run`:\n\n"
       << WriteScenario(first.report.scenarios[0].scenario)
       << "\nTo ask the other oracles: " << ReplayOf(series, first.index) << '\n';
  return text.str();
}

}  // namespace touchstone
