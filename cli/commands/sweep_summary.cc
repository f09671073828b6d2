#include "cli/commands/sweep_summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>

#include <fmt/format.h>

#include "reports/finding/grade.h"
#include "reports/text/counted.h"

namespace touchstone {
namespace {

constexpr const char* kContactRow = "{:<{}}{:<27}{}{:>9}{:>10}{:>11}{:>8}  {}\n";
constexpr const char* kWorldRow = "{:<14}{}{:>9}{:>10}{:>8}  {}\n";

std::string Percent(std::uint64_t part, std::uint64_t all) {
  return all == 0 ? "-"
                  : fmt::format("{:.1f}%", 100.0 * static_cast<double>(part) /
                                               static_cast<double>(all));
}

/** Returns e.g. "excess" or, by a law, "position_error (pendulum)". Some laws have the
 name of their measure. */
std::string InWords(MeasureKind measure, const std::string& law) {
  return fmt::format(
      "{}{}", NameOf(measure),
      law.empty() || law == NameOf(measure) ? "" : fmt::format(" ({})", law));
}

// Returns e.g. "separation_error 0.31, excess 0.02": the measurands that are largest
// relative to their tolerances, as many as fit in a line.
std::string WorstOf(const OracleTally& tally) {
  constexpr std::size_t kShown = 2;
  std::vector<std::pair<Measurand, WorstFinding>> measured;
  for (const auto& [measurand, worst] : tally.worst) {
    if (worst.front().tolerances > 0) measured.emplace_back(measurand, worst.front());
  }
  std::stable_sort(measured.begin(), measured.end(), [](const auto& a, const auto& b) {
    return a.second.tolerances > b.second.tolerances;
  });
  std::string text;
  for (std::size_t i = 0; i < measured.size() && i < kShown; ++i) {
    const auto& [of, worst] = measured[i];
    // A value has no multiple of a zero tolerance.
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", InWords(of.measure, of.law),
                        std::isfinite(worst.tolerances)
                            ? fmt::format("{:.2g}", worst.tolerances)
                            : fmt::format("{:.3g} > 0", worst.value));
  }
  return text;
}

/** Returns what a kind adds to its measure: how the answer ended, or the cause. */
std::string DetailOf(const FailureKind& kind) {
  if (!kind.ending.empty()) return ": " + kind.ending;
  return kind.cause == Cause::kNone ? "" : fmt::format(", {}", NameOf(kind.cause));
}

FailureKind KindOf(const FindingKind& kind) {
  return {kind.measure, kind.cause, kind.law, kind.ending};
}

/** Returns the number of answers that count as examined. Generated contact questions none
 of which touches examine little; the poses of a user may all be apart. */
std::uint64_t ExaminedOf(const Series& series, const OracleTally& tally) {
  const bool is_generated = !IsOfWorlds(series) && !IsOfFile(series);
  return is_generated ? tally.verified_touching : tally.verified;
}

void Add(const OracleTally& tally, const Series& of, std::size_t series, Grade above,
         SubjectSummary& summary) {
  summary.examined += ExaminedOf(of, tally);
  for (const auto& [kind, count] : tally.answers) {
    (kind.verdict == Verdict::kUnsupported ? summary.unsupported : summary.answers) +=
        count;
    if (!IsFailure(kind.verdict)) continue;
    summary.failed += count;
    FailureCluster& cluster = summary.clusters[KindOf(kind)];
    cluster.count += count;
    cluster.grade = std::max(cluster.grade, kind.grade);
  }
  // The decisive finding of an answer need not have the gravest grade.
  for (const auto& [kind, count] : tally.findings)
    summary.fails |= IsFailure(kind.verdict) && IsGraver(kind.grade, above);
  for (const auto& [kind, failures] : tally.failures) {
    FailureCluster& cluster = summary.clusters[KindOf(kind)];
    for (const FailedQuestion& failure : failures) {
      if (cluster.worst && cluster.worst->share >= failure.share) continue;
      cluster.worst = failure;
      cluster.series = series;
    }
  }
}

/** Returns a row of the table. `width` is that of the first column of contact questions.
 */
std::string RowOf(const Series& series, std::size_t width, const std::string& subject,
                  const OracleTally& tally) {
  const auto pair = PairOf(series);
  if (!pair) {
    return fmt::format(kWorldRow, OriginOf(series), subject, tally.asked,
                       Percent(tally.verified, tally.asked), FailureCount(tally),
                       WorstOf(tally));
  }
  return fmt::format(kContactRow, OriginOf(series), width,
                     fmt::format("{} {}", NameOf(pair->first), NameOf(pair->second)),
                     subject, tally.asked, Percent(tally.touching, tally.asked),
                     Percent(tally.undecided, tally.asked), FailureCount(tally),
                     WorstOf(tally));
}

/** Returns the width of the column of families, of which the longest has 17 letters, or
 of files. */
std::size_t OriginWidth(const std::vector<Series>& all) {
  std::size_t width = 19;
  for (const Series& series : all) width = std::max(width, OriginOf(series).size() + 2);
  return width;
}

}  // namespace

std::vector<SubjectSummary> PrintSweepTable(const SweepFile& file, Grade above) {
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
  const Series& first = settings.series.front();
  const std::size_t origin = OriginWidth(settings.series);
  std::cout << (IsOfWorlds(first)
                    ? fmt::format(kWorldRow, "family", column("subject"), "worlds",
                                  "verified", "failed", "worst, in tolerances")
                    : fmt::format(kContactRow, IsOfFile(first) ? "file" : "family",
                                  origin, "pair", column("subject"), "questions",
                                  "touching", "undecided", "failed",
                                  "worst, in tolerances"));
  std::size_t unasked = 0;
  for (std::size_t s = 0; s < settings.series.size(); ++s) {
    const Series& series = settings.series[s];
    const SeriesTally tally = file.Read(s);
    if (std::ranges::all_of(
            tally.oracles, [](const OracleTally& oracle) { return oracle.asked == 0; })) {
      ++unasked;
      continue;
    }
    for (std::size_t i = 0; i < summaries.size(); ++i) {
      const OracleTally& oracle = tally.oracles[i];
      Add(oracle, series, s, above, summaries[i]);
      std::cout << RowOf(series, origin, column(settings.subjects[i]), oracle);
    }
  }
  if (unasked > 0)
    std::cout << fmt::format("{} not asked yet\n",
                             Counted(unasked, "series is", "series are"));
  return summaries;
}

void PrintFailureClusters(const SweepFile& file,
                          const std::vector<SubjectSummary>& subjects) {
  const SweepSettings& settings = file.settings();
  std::uint64_t not_examined = 0;
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    const SubjectSummary& subject = subjects[i];
    std::cout << fmt::format("\n{}: {} failed", settings.subjects[i], subject.failed);
    if (subject.answers > 0) std::cout << fmt::format(" of {}", subject.answers);
    if (subject.unsupported > 0)
      std::cout << fmt::format("; {} more not supported", subject.unsupported);
    std::cout << '\n';
    std::vector<std::pair<FailureKind, FailureCluster>> clusters(subject.clusters.begin(),
                                                                 subject.clusters.end());
    std::stable_sort(clusters.begin(), clusters.end(), [](const auto& a, const auto& b) {
      return a.second.count > b.second.count;
    });
    for (const auto& [kind, cluster] : clusters) {
      if (kind.cause == Cause::kNotExamined) not_examined += cluster.count;
      std::cout << fmt::format(
          "{:>9}  {}{}{}{}\n", cluster.count, InWords(kind.measure, kind.law),
          DetailOf(kind),
          cluster.grade == Grade::kNone ? "" : ", gravest: ", NameOf(cluster.grade));
      if (!cluster.worst) continue;
      std::cout << fmt::format(
          "           {} --subject {}\n",
          ReplayOf(settings.series[cluster.series], cluster.worst->question),
          settings.subjects[i]);
    }
  }
  if (not_examined == 0) return;
  std::cout << fmt::format(
      "\nnot examined: {} failures whose causes were not sought. They are beyond the "
      "first {} questions of their series, and beyond the {} gravest in {} questions "
      "with "
      "the same verdict, measure and size. Any command above seeks the cause of its "
      "failure.\n",
      not_examined, kExaminedBlocks * kContactBlock,
      kExaminedPerKind == 1 ? "one" : fmt::format("{}", kExaminedPerKind), kContactBlock);
}

}  // namespace touchstone
