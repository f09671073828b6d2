#include "reports/ledger/apply_ledger.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/finding/verdict_before.h"
#include "reports/ledger/bounds_file.h"
#include "reports/ledger/glob.h"
#include "reports/text/counted.h"

namespace touchstone {
namespace {

/** A bound as this run uses it. */
struct UsedBound {
  const LedgerCell* cell;
  const LedgerBound* bound;
  std::optional<std::size_t> entry;  ///< The last entry that concerns it.
  bool intermittent = false;         ///< Whether an intermittent entry concerns it.
  bool needed = false;               ///< Whether a finding needs it.
};

/** An oracle of the run, as the ledger sees it. */
struct Rules {
  std::vector<std::size_t> entries;  ///< Those for its name.
  std::map<LedgerCell, UsedBound> bounds;
};

std::string PlaceOf(const Ledger& ledger, const LedgerEntry& entry) {
  return fmt::format("{}:{}", ledger.file.filename().string(), entry.line);
}

std::string PlaceOf(const Ledger& ledger, const LedgerBound& bound) {
  return fmt::format("{}:{}", BoundsFileOf(ledger.file).filename().string(), bound.line);
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

/** A ledger that is being applied to a report. */
class Application {
 public:
  explicit Application(RunReport& report)
      : report_(report), ledger_(report.ledger), scales_(LedgerScalesOf(report)) {
    report_.ledger_use.assign(ledger_.entries.size(), {});
    for (const OracleInfo& info : report.oracles) rules_[info.name];
    for (std::size_t i = 0; i < ledger_.entries.size(); ++i) {
      const LedgerEntry& entry = ledger_.entries[i];
      LedgerUse& use = report_.ledger_use[i];
      use.hidden.resize(entry.measures.size());
      const auto oracle =
          std::find_if(report.oracles.begin(), report.oracles.end(),
                       [&](const OracleInfo& info) { return info.name == entry.oracle; });
      if (oracle == report.oracles.end()) continue;
      use.voided = oracle->version != entry.version;
      rules_[entry.oracle].entries.push_back(i);
    }
    for (const auto& [cell, bound] : ledger_.bounds) {
      const auto rules = rules_.find(cell.oracle);
      if (rules == rules_.end()) continue;
      UsedBound used{&cell, &bound, {}};
      for (const std::size_t i : rules->second.entries) {
        const LedgerEntry& entry = ledger_.entries[i];
        if (!Concerns(entry, cell)) continue;
        used.entry = i;
        used.intermittent = used.intermittent || entry.intermittent;
      }
      rules->second.bounds.emplace(cell, used);
    }
  }

  /** Excuses a finding that an entry covers and that keeps within its bound. */
  void Excuse(Finding& finding) {
    const auto found = rules_.find(finding.oracle);
    if (found == rules_.end() || finding.verdict == Verdict::kUnsupported) return;
    const LedgerCell cell = CellOf(finding);
    const LedgerScale& scale = scales_.at(finding.scenario);
    const double value = ValueForLedger(finding, scale);
    const auto used = found->second.bounds.find(cell);
    UsedBound* bound = used == found->second.bounds.end() ? nullptr : &used->second;
    if (bound != nullptr && !IsImproved(*bound->bound, finding, finding.verdict, value))
      bound->needed = true;
    std::optional<std::size_t> covering;
    for (const std::size_t i : found->second.entries) {
      const LedgerEntry& entry = ledger_.entries[i];
      if (!Concerns(entry, cell)) continue;
      LedgerUse& use = report_.ledger_use[i];
      if (!use.voided) ++use.candidates;
      if (entry.verdict != finding.verdict) continue;
      if (!use.voided) {
        covering = i;
      } else if (!covering) {
        finding.proof += fmt::format(" {} is void: it is for version {}.",
                                     PlaceOf(ledger_, entry), entry.version);
      }
    }
    if (!covering) return;
    const LedgerEntry& entry = ledger_.entries[*covering];
    const std::string refused = Refusal(entry, bound, finding.verdict, value, scale);
    if (!refused.empty()) {
      finding.proof += refused;
      if (bound != nullptr && HasValue(finding.verdict) &&
          HasValue(bound->bound->verdict) &&
          !IsWithin(*bound->bound, entry.verdict, value)) {
        finding.outgrown_entry = static_cast<int>(*covering);
        outgrown_.insert({*covering, finding.measure});
      }
      return;
    }
    LedgerUse& use = report_.ledger_use[*covering];
    const double allowed = bound == nullptr ? 0 : bound->bound->value;
    use.beyond_scene = use.beyond_scene || IsLengthOf(1, finding.measure, allowed, scale);
    Hide(finding, *covering, value, allowed);
  }

  /** Faults entries that have expired, and, in a complete run, all that is not needed. */
  void CheckUse(std::string_view today, bool partial) {
    for (std::size_t i = 0; i < ledger_.entries.size(); ++i) {
      const LedgerEntry& entry = ledger_.entries[i];
      const LedgerUse& use = report_.ledger_use[i];
      if (!rules_.contains(entry.oracle)) continue;
      // ISO dates compare as strings.
      const bool looked_at = !partial || use.candidates > 0;
      if (!today.empty() && entry.expires < today && looked_at) {
        report_.faults.push_back(
            fmt::format("{}: expired on {}: review it and set a new date, or remove it.",
                        PlaceOf(ledger_, entry), entry.expires));
      }
      if (partial || use.voided) continue;
      const std::string why = WhyNotNeeded(i);
      if (!why.empty()) {
        report_.faults.push_back(fmt::format("{}: {} ({} in {}).",
                                             PlaceOf(ledger_, entry), why, entry.oracle,
                                             fmt::join(entry.scenarios, ", ")));
      }
    }
    if (!partial) CheckBounds();
  }

 private:
  /** Returns why a finding that `entry` covers is not excused; "" if it is. */
  std::string Refusal(const LedgerEntry& entry, const UsedBound* bound, Verdict verdict,
                      double value, const LedgerScale& scale) const {
    // A crash now and then has nothing to bound.
    if (entry.intermittent && !HasValue(verdict)) return "";
    if (bound == nullptr) {
      return fmt::format(" {} covers it, but {} has no bound for it.",
                         PlaceOf(ledger_, entry),
                         BoundsFileOf(ledger_.file).filename().string());
    }
    const std::string place = PlaceOf(ledger_, *bound->bound);
    if (!entry.beyond_scene &&
        IsLengthOf(1, bound->cell->measure, bound->bound->value, scale)) {
      return fmt::format(" {} allows {:.3g} of the scene, but {} lacks beyond_scene.",
                         place, bound->bound->value, PlaceOf(ledger_, entry));
    }
    if (IsWithin(*bound->bound, verdict, value)) return "";
    if (HasValue(verdict) && HasValue(bound->bound->verdict)) {
      return fmt::format(" {} allows {:.3g}; {:.3g} exceeds it by {:.3g}.", place,
                         bound->bound->value, value, value - bound->bound->value);
    }
    return fmt::format(" {} is for another verdict.", place);
  }

  void Hide(Finding& finding, std::size_t entry, double value, double bound) {
    const std::vector<MeasureKind>& measures = ledger_.entries[entry].measures;
    const auto measure = std::find(measures.begin(), measures.end(), finding.measure);
    LedgerUse& use = report_.ledger_use[entry];
    LedgerUse::Hidden& hidden =
        use.hidden[static_cast<std::size_t>(measure - measures.begin())];
    if (HasValue(finding.verdict) && (hidden.findings == 0 || value > hidden.worst)) {
      hidden.worst = value;
      hidden.bound = bound;
    }
    ++hidden.findings;
    ++use.causes[finding.cause];
    finding.verdict = Verdict::kKnown;
    finding.ledger_entry = static_cast<int>(entry);
  }

  std::string WhyNotNeeded(std::size_t index) const {
    const LedgerEntry& entry = ledger_.entries[index];
    const LedgerUse& use = report_.ledger_use[index];
    if (use.candidates == 0) {
      return "matches no finding of the run: correct or remove this entry";
    }
    if (entry.intermittent) return "";
    const auto has_outgrown = [&](MeasureKind measure) {
      return outgrown_.contains({index, measure});
    };
    if (use.findings() == 0 && std::ranges::none_of(entry.measures, has_outgrown))
      return "improved: remove this entry, it hides nothing";
    std::vector<std::string_view> unneeded;
    for (std::size_t i = 0; i < use.hidden.size(); ++i) {
      if (use.hidden[i].findings == 0 && !has_outgrown(entry.measures[i]))
        unneeded.push_back(NameOf(entry.measures[i]));
    }
    if (unneeded.empty()) {
      return entry.beyond_scene && !use.beyond_scene
                 ? "improved: remove beyond_scene, no bound is as large as the scene"
                 : "";
    }
    return fmt::format("improved: remove {}, the entry hides none of it",
                       fmt::join(unneeded, ", "));
  }

  /** Adds a fault for each entry with bounds that are not needed, and one for the bounds
   that no entry concerns. */
  void CheckBounds() {
    std::map<std::optional<std::size_t>, std::vector<const UsedBound*>> unneeded;
    for (const auto& [oracle, rules] : rules_) {
      for (const auto& [cell, used] : rules.bounds) {
        if (used.entry && report_.ledger_use[*used.entry].voided) continue;
        if (!used.entry || (!used.needed && !used.intermittent))
          unneeded[used.entry].push_back(&used);
      }
    }
    for (const auto& [entry, bounds] : unneeded) {
      const UsedBound& first = *bounds.front();
      const std::string what =
          entry ? fmt::format(
                      "{}: improved: {} of its bounds hide{} nothing above a twelfth",
                      PlaceOf(ledger_, ledger_.entries[*entry]), bounds.size(),
                      bounds.size() == 1 ? "s" : "")
                : fmt::format("{}: {} that no entry covers",
                              BoundsFileOf(ledger_.file).filename().string(),
                              Counted(bounds.size(), "bound"));
      report_.faults.push_back(
          fmt::format("{}, e.g. {} {} {} ({}): run `touchstone ledger --update`.", what,
                      first.cell->scenario, first.cell->oracle,
                      NameOf(first.cell->measure), PlaceOf(ledger_, *first.bound)));
    }
  }

  RunReport& report_;
  const Ledger& ledger_;
  const std::map<std::string_view, LedgerScale> scales_;
  std::map<std::string_view, Rules> rules_;  ///< Keyed by oracle of the run.
  /** The entries and measures of findings that exceed their bound: such an entry hides
   them no more, and is needed. */
  std::set<std::pair<std::size_t, MeasureKind>> outgrown_;
};

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
                                  std::max(std::abs(truth.lo), std::abs(truth.hi)), true};
  }
  for (const WorldResult& result : report.worlds) scales[result.scenario.id] = {};
  return scales;
}

bool IsLengthOf(double share, MeasureKind measure, double bound,
                const LedgerScale& scale) {
  return scale.is_relative && UnitOf(measure) == "m" && bound >= share;
}

LedgerCell CellOf(const Finding& finding) {
  return {finding.scenario, finding.oracle, finding.measure, finding.law};
}

bool Concerns(const LedgerEntry& entry, const LedgerCell& cell) {
  return entry.oracle == cell.oracle &&
         std::ranges::find(entry.measures, cell.measure) != entry.measures.end() &&
         std::ranges::any_of(entry.scenarios, [&](const std::string& glob) {
           return MatchesGlob(glob, cell.scenario);
         });
}

std::optional<std::size_t> EntryFor(const RunReport& report, const LedgerCell& cell,
                                    Verdict verdict) {
  if (report.ledger.outside_catalogue.contains(cell.scenario)) return std::nullopt;
  for (std::size_t i = report.ledger.entries.size(); i-- > 0;) {
    const LedgerEntry& entry = report.ledger.entries[i];
    if (entry.verdict == verdict && !report.ledger_use[i].voided && Concerns(entry, cell))
      return i;
  }
  return std::nullopt;
}

bool IsWithin(const LedgerBound& bound, Verdict verdict, double value) {
  if (!HasValue(verdict)) return bound.verdict == verdict;
  // Written so that a NaN is refused.
  return HasValue(bound.verdict) && value <= bound.value;
}

bool IsImproved(const LedgerBound& bound, const Finding& finding, Verdict verdict,
                double value) {
  if (!HasValue(bound.verdict)) return verdict != bound.verdict;
  // The value of `touching` is the truth's, whatever was answered.
  return finding.value == 0 || value < bound.value * kImproved;
}

void ApplyLedger(RunReport& report, std::string_view today, bool partial,
                 const std::function<bool(std::string_view)>& is_oracle) {
  for (const LedgerEntry& entry : report.ledger.entries) {
    if (!is_oracle || is_oracle(entry.oracle)) continue;
    report.faults.push_back(
        fmt::format("{}: no build has an oracle \"{}\": correct or remove this entry.",
                    PlaceOf(report.ledger, entry), entry.oracle));
  }
  Application application(report);
  for (Finding& finding : report.findings) {
    if (report.ledger.entries.empty()) break;
    if (!report.ledger.outside_catalogue.contains(finding.scenario) &&
        !IsSetUpOtherwise(report, finding))
      application.Excuse(finding);
  }
  application.CheckUse(today, partial);
}

void ApplyAgain(RunReport& report) {
  for (Finding& finding : report.findings) {
    finding.verdict = VerdictBefore(finding, report.ledger.entries);
    finding.ledger_entry.reset();
    finding.outgrown_entry.reset();
  }
  ApplyLedger(report, "", true);
}

}  // namespace touchstone
