#include "reports/clusters/clusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "reports/clusters/measure_words.h"
#include "reports/clusters/ordinary.h"
#include "reports/finding/grade.h"
#include "reports/finding/verdict_before.h"
#include "reports/text/counted.h"
#include "reports/text/si_quantity.h"

namespace touchstone {
namespace {

/** Returns the entry that knows a fault, whether or not the fault keeps within its bound;
 null if there is none. */
const LedgerEntry* EntryOf(const RunReport& report, const Finding& finding) {
  const std::optional<int> entry =
      finding.ledger_entry ? finding.ledger_entry : finding.outgrown_entry;
  return entry ? &report.ledger.entries[static_cast<std::size_t>(*entry)] : nullptr;
}

/** Identifies a cluster: its fault in the ledger, and whether its bounds excuse it;
 outside the ledger the oracle, verdict, measure and cause. */
using Key = std::tuple<std::string, Verdict, MeasureKind, Cause>;

Key KeyOf(const RunReport& report, const Finding& finding) {
  if (const LedgerEntry* entry = EntryOf(report, finding)) {
    return {FaultOf(*entry), finding.ledger_entry ? Verdict::kKnown : Verdict::kFail,
            MeasureKind::kTouching, Cause::kNone};
  }
  return {finding.oracle, finding.verdict, finding.measure, finding.cause};
}

/** Returns the reason of a cluster outside the ledger. */
std::string ReasonOf(const Finding& finding) {
  std::string reason =
      fmt::format("{} {}", finding.oracle, FaultInWords(finding.measure));
  switch (finding.verdict) {
    case Verdict::kCrashed:
    case Verdict::kTimedOut:
      return fmt::format("{} {}", finding.oracle,
                         finding.verdict == Verdict::kCrashed ? "crashes" : "hangs");
    case Verdict::kInvalid:
      reason = finding.oracle + " gives an invalid answer";
      break;
    case Verdict::kDisagree:
      return finding.oracle + " differs from the others, and nobody is proved right";
    default:
      break;
  }
  if (finding.cause != Cause::kNone)
    reason += fmt::format(" ({})", NameOf(finding.cause));
  return reason;
}

/** Returns how ordinary each question is. */
std::vector<double> OrdinaryOfAll(const RunReport& report) {
  std::vector<double> ordinary;
  for (const ScenarioResult& result : report.scenarios)
    ordinary.push_back(OrdinaryOf(result.scenario.contact, result.truth));
  for (const WorldResult& result : report.worlds)
    ordinary.push_back(OrdinaryOf(result.scenario.world));
  return ordinary;
}

/** Returns `share`, with a NaN as the largest of all. */
double Comparable(double share) {
  return std::isnan(share) ? std::numeric_limits<double>::infinity() : share;
}

/** Returns the key by which the worst finding of a cluster is the greatest: a length
 before any other value, then its share. The gravest grades, from 10 % on, count as one,
 since the depth of a wrong hit says less than an error ten times as large. */
std::tuple<Grade, bool, double> SizeOf(const Finding& finding, Grade grade,
                                       double share) {
  const bool is_length =
      finding.measure == MeasureKind::kTouching || UnitOf(finding.measure) == "m";
  return {std::min(grade, Grade::kGross), is_length, Comparable(share)};
}

/** Fills a cluster from its findings. */
void Sum(const RunReport& report, const Clusters& all,
         const std::vector<double>& ordinary, Cluster& cluster) {
  std::map<std::size_t, std::size_t> oracles;
  std::map<std::size_t, std::pair<Grade, double>> questions;
  std::tuple<Grade, bool, double> worst{Grade::kNone, false, -1};
  for (const std::size_t f : cluster.findings) {
    const Finding& finding = report.findings[f];
    const auto [question, oracle] = all.places[f];
    const std::pair<Grade, double> size{finding.grade, Comparable(all.shares[f])};
    ++oracles[oracle];
    auto& of_question = questions.try_emplace(question, size).first->second;
    of_question = std::max(of_question, size);
    cluster.ordinary = std::max(cluster.ordinary, ordinary[question]);
    cluster.rank = std::max(cluster.rank,
                            static_cast<double>(size.first) - (1 - ordinary[question]));
    cluster.grade = std::max(cluster.grade, size.first);
    if (const auto key = SizeOf(finding, size.first, all.shares[f]); key > worst) {
      worst = key;
      cluster.worst = f;
    }
  }
  const Finding& finding = report.findings[cluster.worst];
  const LedgerEntry* entry = EntryOf(report, finding);
  cluster.is_new = entry == nullptr;
  cluster.has_outgrown = finding.outgrown_entry.has_value();
  cluster.reason = entry ? entry->reason : ReasonOf(finding);
  cluster.title = entry ? FaultOf(*entry) : cluster.reason + '.';
  if (entry) cluster.upstream = entry->upstream;
  cluster.cause = finding.cause;
  if (entry) {
    cluster.responsible = entry->responsible;
  } else if (finding.cause == Cause::kModel) {
    cluster.responsible = Responsible::kModel;
  } else if (finding.cause == Cause::kSetting) {
    cluster.responsible = Responsible::kAdapter;
  }
  cluster.share = all.shares[cluster.worst];
  const bool is_touch = finding.measure == MeasureKind::kTouching;
  cluster.unit = is_touch ? "m" : UnitOf(finding.measure);
  cluster.error =
      is_touch
          ? cluster.share * SizeOfQuestion(report, all.places[cluster.worst].question)
          : finding.value;
  for (const auto& [oracle, count] : oracles) cluster.oracles.push_back(oracle);
  cluster.rank += std::log2(static_cast<double>(oracles.size())) / 2 +
                  std::log10(static_cast<double>(questions.size()));
  std::ranges::stable_sort(cluster.oracles, std::greater{},
                           [&](std::size_t o) { return oracles.at(o); });
  for (const auto& [question, size] : questions) cluster.questions.push_back(question);
  std::ranges::stable_sort(cluster.questions, std::greater{}, [&](std::size_t q) {
    const auto& [grade, share] = questions.at(q);
    return std::tuple(grade, ordinary[q], share);
  });
}

/** Returns the angle and the distance of two places of a body, if most of the error is
 the angle: "176° and 3 cm". The error itself, distance + angle · radius, would be a
 length that nothing moves by. Otherwise "". */
std::string TurnInWords(const Finding& finding) {
  const Proof* proof = finding.evidence.get();
  if (!proof || proof->kind != ProofKind::kPlaces || proof->points_W.size() != 2)
    return "";
  const double distance = (proof->points_W[1] - proof->points_W[0]).norm();
  if (!(proof->rest > 0) || !(finding.value > 2 * distance)) return "";
  return fmt::format("{:.3g}° and {}", proof->rest * 180 / std::numbers::pi,
                     SiQuantity(distance, "m"));
}

/** Returns the size of the worst fault in words, after ", "; "" without one. */
std::string SizeInWords(const RunReport& report, const Cluster& cluster) {
  const Finding& worst = report.findings[cluster.worst];
  const Verdict verdict = VerdictBefore(worst, report.ledger.entries);
  if (IsUnusable(verdict) || cluster.grade == Grade::kNone || cluster.unit.empty() ||
      cluster.error == 0) {
    return "";
  }
  if (const std::string turn = TurnInWords(worst); !turn.empty())
    return fmt::format(", at worst {}", turn);
  const std::string size = SiQuantity(cluster.error, cluster.unit);
  std::string share;
  if (cluster.unit == "m") {
    std::size_t question = 0;
    while (IdOf(report, question) != worst.scenario) ++question;
    share = ShareInWords(cluster.share, SizedPartOf(report, question));
  }
  return fmt::format(", at worst {}{}{}", size, share.empty() ? "" : ", ", share);
}

/** Joins "a", "b" and "c" to "a, b and c". */
std::string InARow(const std::vector<std::string>& names) {
  std::string row;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) row += i + 1 == names.size() ? " and " : ", ";
    row += names[i];
  }
  return row;
}

}  // namespace

Clusters ClustersOf(const RunReport& report) {
  Clusters all;
  all.places = PlacesOf(report);
  all.shares = SharesOf(report, all.places);
  all.of_finding.assign(report.findings.size(), -1);
  std::map<Key, Cluster> clusters;
  for (std::size_t f = 0; f < report.findings.size(); ++f) {
    const Finding& finding = report.findings[f];
    if (!IsFailure(finding.verdict) && finding.verdict != Verdict::kKnown) continue;
    Cluster& cluster = clusters[KeyOf(report, finding)];
    cluster.findings.push_back(f);
  }
  const std::vector<double> ordinary = OrdinaryOfAll(report);
  for (auto& [key, cluster] : clusters) {
    Sum(report, all, ordinary, cluster);
    all.ranked.push_back(std::move(cluster));
  }
  std::ranges::stable_sort(all.ranked, std::greater{}, [](const Cluster& cluster) {
    return std::tuple(cluster.rank, Comparable(cluster.share), cluster.oracles.size(),
                      cluster.findings.size());
  });
  for (std::size_t c = 0; c < all.ranked.size(); ++c) {
    for (const std::size_t f : all.ranked[c].findings)
      all.of_finding[f] = static_cast<int>(c);
  }
  return all;
}

std::string NamesOf(const RunReport& report, const std::vector<std::size_t>& oracles) {
  std::vector<std::string> names;
  std::vector<std::string> libraries;
  for (const std::size_t o : oracles) {
    names.push_back(report.oracles[o].name);
    if (std::ranges::find(libraries, report.oracles[o].library) == libraries.end())
      libraries.push_back(report.oracles[o].library);
  }
  return InARow(libraries.size() > 1 ? libraries : names);
}

std::string ExtentOf(const RunReport& report, const Cluster& cluster) {
  // The title of a new fault names its oracle.
  const std::string whose =
      cluster.is_new ? "In" : NamesOf(report, cluster.oracles) + ", in";
  return fmt::format("{} {}{}.", whose, Counted(cluster.questions.size(), "scenario"),
                     SizeInWords(report, cluster));
}

}  // namespace touchstone
