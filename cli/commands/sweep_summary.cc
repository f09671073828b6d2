#include "cli/commands/sweep_summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>

#include <fmt/format.h>

namespace touchstone {
namespace {

constexpr const char* kRow = "{:<19}{:<27}{}{:>9}{:>10}{:>11}{:>8}  {}\n";

std::string Percent(std::uint64_t part, std::uint64_t all) {
  return all == 0 ? "-"
                  : fmt::format("{:.1f}%", 100.0 * static_cast<double>(part) /
                                               static_cast<double>(all));
}

// Returns e.g. "separation_error 0.31, excess 0.02": the measures that are largest
// relative to their tolerances, as many as fit in a line.
std::string WorstOf(const OracleTally& tally) {
  constexpr std::size_t kShown = 2;
  std::vector<std::pair<MeasureKind, WorstFinding>> measures;
  for (const auto& [measure, worst] : tally.worst) {
    if (worst.front().tolerances > 0) measures.emplace_back(measure, worst.front());
  }
  std::stable_sort(measures.begin(), measures.end(), [](const auto& a, const auto& b) {
    return a.second.tolerances > b.second.tolerances;
  });
  std::string text;
  for (std::size_t i = 0; i < measures.size() && i < kShown; ++i) {
    const WorstFinding& worst = measures[i].second;
    // A value has no multiple of a zero tolerance.
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", NameOf(measures[i].first),
                        std::isfinite(worst.tolerances)
                            ? fmt::format("{:.2g}", worst.tolerances)
                            : fmt::format("{:.3g} > 0", worst.value));
  }
  return text;
}

bool HasNoAnswer(Verdict verdict) {
  return verdict == Verdict::kCrashed || verdict == Verdict::kTimedOut ||
         verdict == Verdict::kInvalid;
}

void Add(const OracleTally& tally, std::size_t series, Grade least,
         SubjectSummary& summary) {
  summary.verified_touching += tally.verified_touching;
  for (const auto& [kind, count] : tally.answers) {
    if (kind.verdict != Verdict::kUnsupported) summary.answers += count;
    if (!IsFailure(kind.verdict)) continue;
    summary.failed += count;
    if (kind.band >= least || HasNoAnswer(kind.verdict)) summary.failed_in_band += count;
    FailureCluster& cluster = summary.clusters[{kind.measure, kind.cause}];
    cluster.count += count;
    cluster.band = std::max(cluster.band, kind.band);
  }
  for (const auto& [kind, failures] : tally.failures) {
    FailureCluster& cluster = summary.clusters[kind];
    for (const FailedQuestion& failure : failures) {
      if (cluster.worst && cluster.worst->share >= failure.share) continue;
      cluster.worst = failure;
      cluster.series = series;
    }
  }
}

}  // namespace

std::vector<SubjectSummary> PrintSweepTable(const SweepFile& file, Grade least) {
  const SweepSettings& settings = file.settings();
  std::vector<SubjectSummary> summaries(settings.subjects.size());
  std::size_t width = 0;
  if (settings.subjects.size() > 1) {
    for (const std::string& name : settings.subjects)
      width = std::max(width, name.size() + 2);
  }
  const auto column = [width](std::string_view name) {
    return width == 0 ? "" : fmt::format("{:<{}}", name, width);
  };
  std::cout << fmt::format(kRow, "family", "pair", column("subject"), "questions",
                           "touching", "undecided", "failed", "worst, in tolerances");
  for (std::size_t s = 0; s < settings.series.size(); ++s) {
    const QuestionSeries& series = settings.series[s];
    const SeriesTally tally = file.Read(s);
    for (std::size_t i = 0; i < summaries.size(); ++i) {
      const OracleTally& oracle = tally.oracles[i];
      Add(oracle, s, least, summaries[i]);
      std::cout << fmt::format(kRow, NameOf(series.family),
                               fmt::format("{} {}", NameOf(series.A), NameOf(series.B)),
                               column(settings.subjects[i]), oracle.asked,
                               Percent(oracle.touching, oracle.asked),
                               Percent(oracle.undecided, oracle.asked),
                               FailureCount(oracle), WorstOf(oracle));
    }
  }
  return summaries;
}

void PrintFailureClusters(const SweepFile& file,
                          const std::vector<SubjectSummary>& subjects) {
  const SweepSettings& settings = file.settings();
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    const SubjectSummary& subject = subjects[i];
    std::cout << fmt::format("\n{}: {} failed", settings.subjects[i], subject.failed);
    if (subject.answers > 0) std::cout << fmt::format(" of {}", subject.answers);
    std::cout << '\n';
    std::vector<std::pair<FailureKind, FailureCluster>> clusters(subject.clusters.begin(),
                                                                 subject.clusters.end());
    std::stable_sort(clusters.begin(), clusters.end(), [](const auto& a, const auto& b) {
      return a.second.count > b.second.count;
    });
    for (const auto& [kind, cluster] : clusters) {
      std::cout << fmt::format(
          "{:>9}  {}{}{}{}{}\n", cluster.count, NameOf(kind.measure),
          kind.cause == Cause::kNone ? "" : ", ", NameOf(kind.cause),
          cluster.band == Grade::kNone ? "" : ", gravest: ", NameOf(cluster.band));
      if (!cluster.worst) continue;
      std::cout << fmt::format(
          "           {} --subject {}\n",
          ReplayOf(settings.series[cluster.series], cluster.worst->question),
          settings.subjects[i]);
    }
  }
}

}  // namespace touchstone
