#include "reports/ledger/apply_ledger.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/ledger/glob.h"

namespace touchstone {
namespace {

/** A ledger entry as this run applies it. */
struct Rule {
  const LedgerEntry& entry;
  LedgerUse& use;
  int index;
  bool voided;  ///< Whether the library has another version than the entry.
};

std::string PlaceOf(const Ledger& ledger, const LedgerEntry& entry) {
  return fmt::format("{}:{}", ledger.file.filename().string(), entry.line);
}

/** Returns what `entry` accepts for the measure of `finding`, or nullptr where the entry
 does not concern it. */
const Accepted* Concerned(const LedgerEntry& entry, const Finding& finding) {
  if (entry.oracle != finding.oracle) return nullptr;
  const auto found =
      std::find_if(entry.accepted.begin(), entry.accepted.end(),
                   [&](const Accepted& of) { return of.measure == finding.measure; });
  if (found == entry.accepted.end()) return nullptr;
  return MatchesGlob(entry.scenarios, finding.scenario) ? &*found : nullptr;
}

bool HasValue(Verdict verdict) {
  return verdict == Verdict::kFail || verdict == Verdict::kDisagree;
}

/** Excuses `finding` by the first rule that covers it. */
void Excuse(Finding& finding, const LedgerScale& scale, std::span<Rule> rules,
            const Ledger& ledger) {
  std::string refused;
  const Verdict verdict = finding.verdict;
  for (Rule& rule : rules) {
    const Accepted* accepted = Concerned(rule.entry, finding);
    if (accepted == nullptr || verdict == Verdict::kUnsupported) continue;
    if (!rule.voided) ++rule.use.candidates;
    if (finding.ledger_entry || verdict != rule.entry.verdict) continue;
    const std::string place = PlaceOf(ledger, rule.entry);
    if (rule.voided) {
      refused =
          fmt::format(" {} is void: it is for version {}.", place, rule.entry.version);
      continue;
    }
    const double value = HasValue(verdict) ? ValueForLedger(finding, scale) : 0;
    // Written so that a NaN is refused.
    if (!(value <= accepted->bound)) {
      refused = fmt::format(" {} allows {:.3g}; {:.3g} exceeds it by {:.3g}.", place,
                            accepted->bound, value, value - accepted->bound);
      continue;
    }
    finding.verdict = Verdict::kKnown;
    finding.ledger_entry = rule.index;
    LedgerUse::Hidden& hidden =
        rule.use.hidden[static_cast<std::size_t>(accepted - rule.entry.accepted.data())];
    ++hidden.findings;
    hidden.worst = std::max(hidden.worst, value);
  }
  if (!finding.ledger_entry) finding.proof += refused;
}

/** Returns whether `finding` is on a motion with other settings than those for which the
 entries were written. */
bool IsSetUpOtherwise(const RunReport& report, const Finding& finding) {
  const auto oracle =
      std::find_if(report.oracles.begin(), report.oracles.end(),
                   [&](const OracleInfo& info) { return info.name == finding.oracle; });
  if (oracle == report.oracles.end() || oracle->setup.IsDefault()) return false;
  return std::any_of(
      report.worlds.begin(), report.worlds.end(),
      [&](const WorldResult& world) { return world.scenario.id == finding.scenario; });
}

std::string WhyNotNeeded(const Rule& rule) {
  if (rule.voided) return "";
  if (rule.use.candidates == 0) {
    return "matches no finding of the run: correct or remove this entry";
  }
  if (rule.entry.intermittent) return "";
  if (rule.use.findings() == 0) return "improved: remove this entry, it hides nothing";
  std::vector<std::string> improvements;
  for (std::size_t i = 0; i < rule.use.hidden.size(); ++i) {
    const Accepted& accepted = rule.entry.accepted[i];
    const LedgerUse::Hidden& hidden = rule.use.hidden[i];
    if (hidden.findings == 0) {
      improvements.push_back(
          fmt::format("remove {}, the entry hides none of it", NameOf(accepted.measure)));
    } else if (HasValue(rule.entry.verdict) &&
               hidden.worst < accepted.bound * kImproved) {
      improvements.push_back(
          fmt::format("lower the bound {:.3g} of {}, the worst hidden value is {:.3g}",
                      accepted.bound, NameOf(accepted.measure), hidden.worst));
    }
  }
  if (improvements.empty()) return "";
  return fmt::format("improved: {}", fmt::join(improvements, "; "));
}

}  // namespace

double ValueForLedger(const Finding& finding, const LedgerScale& scale) {
  if (finding.measure == MeasureKind::kTouching) return scale.from_touching / scale.size;
  return UnitOf(finding.measure) == "m" ? finding.value / scale.size : finding.value;
}

std::map<std::string_view, LedgerScale> LedgerScalesOf(const RunReport& report) {
  std::map<std::string_view, LedgerScale> scales;
  for (const ScenarioResult& result : report.scenarios) {
    const Enclosure& truth = result.truth.separation;
    scales[result.scenario.id] = {SceneSize(result.scenario.contact),
                                  std::max(std::abs(truth.lo), std::abs(truth.hi))};
  }
  for (const WorldResult& result : report.worlds) scales[result.scenario.id] = {};
  return scales;
}

void ApplyLedger(RunReport& report, std::string_view today, bool partial,
                 const std::function<bool(std::string_view)>& is_oracle) {
  const std::vector<LedgerEntry>& entries = report.ledger.entries;
  report.ledger_use.assign(entries.size(), {});
  for (std::size_t i = 0; i < entries.size(); ++i) {
    report.ledger_use[i].hidden.resize(entries[i].accepted.size());
  }
  std::map<std::string, std::vector<Rule>> rules;  // Keyed by oracle.
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto oracle = std::find_if(
        report.oracles.begin(), report.oracles.end(),
        [&](const OracleInfo& info) { return info.name == entries[i].oracle; });
    if (oracle == report.oracles.end()) {
      if (!partial && is_oracle && !is_oracle(entries[i].oracle)) {
        report.faults.push_back(fmt::format(
            "{}: no build has an oracle \"{}\": correct or remove this entry.",
            PlaceOf(report.ledger, entries[i]), entries[i].oracle));
      }
      continue;
    }
    rules[entries[i].oracle].push_back({entries[i], report.ledger_use[i],
                                        static_cast<int>(i),
                                        oracle->version != entries[i].version});
  }
  const std::map<std::string_view, LedgerScale> scales = LedgerScalesOf(report);
  for (Finding& finding : report.findings) {
    const auto found = rules.find(finding.oracle);
    if (found == rules.end() ||
        report.ledger.outside_catalogue.contains(finding.scenario) ||
        IsSetUpOtherwise(report, finding))
      continue;
    Excuse(finding, scales.at(finding.scenario), found->second, report.ledger);
  }
  for (const auto& [oracle, of_oracle] : rules) {
    for (const Rule& rule : of_oracle) {
      const std::string place = PlaceOf(report.ledger, rule.entry);
      // ISO dates compare as strings.
      const bool looked_at = !partial || rule.use.candidates > 0;
      if (!today.empty() && rule.entry.expires < today && looked_at) {
        report.faults.push_back(
            fmt::format("{}: expired on {}: review it and set a new date, or remove it.",
                        place, rule.entry.expires));
      }
      const std::string why = partial ? "" : WhyNotNeeded(rule);
      if (!why.empty()) {
        report.faults.push_back(
            fmt::format("{}: {} ({} in {}).", place, why, oracle, rule.entry.scenarios));
      }
    }
  }
}

}  // namespace touchstone
