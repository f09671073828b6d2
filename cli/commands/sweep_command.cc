#include "cli/commands/sweep_command.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "cli/did_you_mean.h"
#include "cli/input_error.h"
#include "cli/output_folder.h"
#include "cli/progress_bar.h"
#include "reports/sweep/sweep.h"
#include "reports/writers/explanation_writer.h"
#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

std::vector<Family> FamiliesNamed(const std::string& name) {
  if (name == "all") return AllFamilies();
  if (const std::optional<Family> family = FamilyNamed(name)) return {*family};
  std::vector<std::string_view> names = {"all"};
  for (const Family family : AllFamilies()) names.push_back(NameOf(family));
  throw InputError(fmt::format("there is no family '{}'{}; expected one of: {}", name,
                               DidYouMean(name, names), fmt::join(names, ", ")));
}

using KindPair = std::pair<ShapeKind, ShapeKind>;

ShapeKind ShapeKindNamed(const std::string& name) {
  std::array<std::string_view, kShapeKinds> names;
  for (int i = 0; i < kShapeKinds; ++i) {
    const ShapeKind kind = static_cast<ShapeKind>(i);
    if (NameOf(kind) == name) return kind;
    names[static_cast<std::size_t>(i)] = NameOf(kind);
  }
  throw InputError(fmt::format("there is no shape '{}'{}; expected one of: {}", name,
                               DidYouMean(name, names), fmt::join(names, ", ")));
}

std::vector<KindPair> PairsOf(const SweepArguments& arguments,
                              const OracleInfo& subject) {
  if (!arguments.pair.empty()) return {PairNamed(arguments.pair)};
  std::vector<KindPair> pairs;
  for (int a = 0; a < kShapeKinds; ++a) {
    for (int b = 0; b < kShapeKinds; ++b) {
      const KindPair pair(static_cast<ShapeKind>(a), static_cast<ShapeKind>(b));
      if (subject.For(pair.first, pair.second).supported) pairs.push_back(pair);
    }
  }
  return pairs;
}

// Returns e.g. "separation_error 0.31, excess 0.02": the measures that are largest
// relative to their tolerances, as many as fit in a line.
std::string WorstOf(const SweepResult& result) {
  constexpr std::size_t kShown = 2;
  std::vector<std::pair<MeasureKind, WorstMeasure>> measures;
  for (std::size_t i = 0; i < result.worst.size(); ++i) {
    if (!result.worst[i] || result.worst[i]->relative == 0) continue;
    measures.emplace_back(static_cast<MeasureKind>(i), *result.worst[i]);
  }
  std::stable_sort(measures.begin(), measures.end(), [](const auto& a, const auto& b) {
    return a.second.relative > b.second.relative;
  });
  std::string text;
  for (std::size_t i = 0; i < measures.size() && i < kShown; ++i) {
    const WorstMeasure& worst = measures[i].second;
    // A value has no multiple of a zero tolerance.
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", NameOf(measures[i].first),
                        std::isfinite(worst.relative)
                            ? fmt::format("{:.2g}", worst.relative)
                            : fmt::format("{:.3g} > 0", worst.value));
  }
  return text;
}

void WriteFailures(const OutputFolder& folder, const SweepResult& result) {
  for (const FailedQuestion& failure : result.first_failures) {
    const Scenario& scenario = failure.report.scenarios[0].scenario;
    folder.Write(scenario.id + ".toml",
                 [&](std::ostream& out) { out << WriteScenario(scenario); });
  }
}

void PrintFailures(const QuestionSeries& series, const SweepResult& result) {
  for (const FailedQuestion& failure : result.first_failures) {
    std::cout << '\n' << WriteScenario(failure.report.scenarios[0].scenario) << '\n';
    WriteExplanation(failure.report, {}, std::cout);
    std::cout << "Repeat with: " << ReplayOf(series, failure.index) << '\n';
  }
}

}  // namespace

std::pair<ShapeKind, ShapeKind> PairNamed(const std::vector<std::string>& names) {
  const KindPair pair(ShapeKindNamed(names[0]), ShapeKindNamed(names[1]));
  if (pair == KindPair(ShapeKind::kHalfSpace, ShapeKind::kHalfSpace)) {
    throw InputError(
        "two half-spaces are not a valid pair; expected at least one other shape");
  }
  return pair;
}

int SweepCommand(const Session& session, const SweepArguments& arguments) {
  const std::vector<const Oracle*> oracles =
      SelectOracles(session.registry, arguments.oracles);
  const std::vector<Family> families = FamiliesNamed(arguments.family);
  const std::vector<KindPair> pairs = PairsOf(arguments, oracles.front()->info());
  std::optional<OutputFolder> out;
  if (arguments.out) out.emplace(*arguments.out);
  std::vector<std::pair<QuestionSeries, SweepResult>> results;
  std::uint64_t touching = 0;
  std::uint64_t failed = 0;
  std::cout << fmt::format("{:<19}{:<27}{:>9}{:>10}{:>11}{:>8}  worst, in tolerances\n",
                           "family", "pair", "questions", "touching", "undecided",
                           "failed");
  for (const Family family : families) {
    for (const auto& [A, B] : pairs) {
      const QuestionSeries series{.family = family,
                                  .A = A,
                                  .B = B,
                                  .seed = arguments.seed,
                                  .first = arguments.first,
                                  .count = arguments.count};
      ProgressBar bar(session.terminal.progress && !arguments.quiet);
      SweepResult result =
          Sweep(series, oracles,
                {.jobs = arguments.jobs,
                 .on_progress = [&bar](std::size_t done, std::size_t all) {
                   bar.Show(done, all);
                 }});
      // A pair that the subject does not support verifies nothing, touching or not.
      if (result.unsupported < result.asked) touching += result.touching;
      failed += result.failed;
      std::cout << fmt::format("{:<19}{:<27}{:>9}{:>9.1f}%{:>10.1f}%{:>8}  {}\n",
                               NameOf(family), fmt::format("{} {}", NameOf(A), NameOf(B)),
                               result.asked,
                               100.0 * static_cast<double>(result.touching) /
                                   static_cast<double>(result.asked),
                               100.0 * static_cast<double>(result.undecided) /
                                   static_cast<double>(result.asked),
                               result.failed, WorstOf(result));
      if (!result.first_failures.empty()) results.emplace_back(series, std::move(result));
    }
  }
  for (const auto& [series, result] : results) {
    if (out) WriteFailures(*out, result);
    if (!arguments.quiet) PrintFailures(series, result);
  }
  std::cout << fmt::format("\n{}: {} failed\n", oracles.front()->info().name, failed);
  if (failed > 0) return 1;
  if (touching > 0) return 0;
  std::cerr << "touchstone: nothing was verified; expected a touching question that "
            << oracles.front()->info().name << " supports\n";
  return 2;
}

}  // namespace touchstone
