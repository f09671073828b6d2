#include "reports/ledger/audit_ledger.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/ledger/apply_ledger.h"
#include "reports/ledger/bounds_file.h"
#include "reports/text/counted.h"

namespace touchstone {
namespace {

/** Returns whether the ledger would excuse a failure of `value` in a cell. */
bool WouldExcuse(const RunReport& report, const LedgerCell& cell, double value) {
  const auto bound = report.ledger.bounds.find(cell);
  return bound != report.ledger.bounds.end() &&
         IsWithin(bound->second, Verdict::kFail, value) &&
         EntryFor(report, cell, Verdict::kFail).has_value();
}

void AddContradictions(const RunReport& report, std::size_t entry, bool partial,
                       std::vector<LedgerAudit::Contradiction>& contradictions) {
  // A finding without a cause contradicts none.
  std::map<Cause, int> found = report.ledger_use[entry].causes;
  found.erase(Cause::kNone);
  if (found.empty()) return;
  const std::vector<Cause>& said = report.ledger.entries[entry].causes;
  for (const auto& [cause, findings] : found) {
    if (std::ranges::find(said, cause) == said.end())
      contradictions.push_back({entry, cause, findings});
  }
  for (const Cause cause : said) {
    if (!partial && !found.contains(cause)) contradictions.push_back({entry, cause, 0});
  }
}

std::string PlaceOf(const RunReport& report, std::size_t entry) {
  return fmt::format("{}:{}", report.ledger.file.filename().string(),
                     report.ledger.entries[entry].line);
}

void WriteLarge(const LedgerAudit& audit, std::ostream& out) {
  out << fmt::format("\n{} above {:.0f} % of the scene\n",
                     Counted(audit.large.size(), "bound"), 100 * kLargeBound);
  // One line per oracle and measure: its count and the largest.
  std::map<std::pair<std::string_view, MeasureKind>,
           std::vector<const LedgerAudit::Large*>>
      groups;
  for (const LedgerAudit::Large& large : audit.large)
    groups[{large.cell.oracle, large.cell.measure}].push_back(&large);
  for (const auto& [key, group] : groups) {
    out << fmt::format("  {:>5}  {} {}, the largest {:.2g} in {}\n", group.size(),
                       key.first, NameOf(key.second), group.front()->bound,
                       group.front()->cell.scenario);
  }
}

std::string SentenceOf(const RunReport& report,
                       const LedgerAudit::Contradiction& contradiction) {
  const auto& [index, cause, findings] = contradiction;
  const LedgerEntry& entry = report.ledger.entries[index];
  return fmt::format("{}: says {}, but {} ({} in {})", PlaceOf(report, index),
                     CausesOf(entry),
                     findings == 0   ? fmt::format("none is {}", NameOf(cause))
                     : findings == 1 ? fmt::format("1 is {}", NameOf(cause))
                                     : fmt::format("{} are {}", findings, NameOf(cause)),
                     entry.oracle, fmt::join(entry.scenarios, ", "));
}

void WriteContradictions(const RunReport& report, const LedgerAudit& audit,
                         std::ostream& out) {
  out << fmt::format("\n{} of causes\n",
                     Counted(audit.contradictions.size(), "contradiction"));
  for (const LedgerAudit::Contradiction& contradiction : audit.contradictions)
    out << "  " << SentenceOf(report, contradiction) << '\n';
}

void WriteEntries(const RunReport& report, std::ostream& out) {
  std::vector<std::size_t> order(report.ledger.entries.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, std::ranges::greater(), [&](std::size_t i) {
    return report.ledger_use[i].findings();
  });
  out << "\nFindings hidden by each entry\n";
  for (const std::size_t i : order) {
    const LedgerEntry& entry = report.ledger.entries[i];
    if (report.ledger_use[i].candidates == 0 && !report.ledger_use[i].voided) continue;
    out << fmt::format("  {:>5}  {} {} {} in {}{}\n", report.ledger_use[i].findings(),
                       PlaceOf(report, i), entry.oracle, NameOf(entry.verdict),
                       fmt::join(entry.scenarios, ", "),
                       report.ledger_use[i].voided ? " (void here)" : "");
  }
}

}  // namespace

LedgerAudit AuditLedger(const RunReport& report, bool partial) {
  const std::map<std::string_view, LedgerScale> scales = LedgerScalesOf(report);
  LedgerAudit audit;
  for (const Finding& finding : report.findings) {
    const LedgerScale& scale = scales.at(finding.scenario);
    const LedgerCell cell = CellOf(finding);
    if (finding.verdict != Verdict::kPass || finding.oracle == report.subject ||
        !scale.is_relative || UnitOf(finding.measure) != "m")
      continue;
    ++audit.passing;
    if (WouldExcuse(report, cell, kSoughtError)) ++audit.excusable;
    if (finding.tolerance >= kSoughtError * scale.size) ++audit.tolerated;
  }
  for (std::size_t i = 0; i < report.ledger_use.size(); ++i) {
    audit.hidden += report.ledger_use[i].findings();
    AddContradictions(report, i, partial, audit.contradictions);
  }
  for (const auto& [cell, bound] : report.ledger.bounds) {
    const auto scale = scales.find(cell.scenario);
    if (scale != scales.end() &&
        IsLengthOf(kLargeBound, cell.measure, bound.value, scale->second))
      audit.large.push_back({cell, bound.value});
  }
  std::ranges::stable_sort(audit.large, std::ranges::greater(),
                           &LedgerAudit::Large::bound);
  return audit;
}

void WriteAudit(const RunReport& report, const LedgerAudit& audit, std::ostream& out) {
  const Ledger& ledger = report.ledger;
  out << fmt::format(
      "An error of {:g} of the scene would be seen in {:.2f} % of {} that pass: the "
      "ledger\nwould excuse it in {}. In {} the tolerance of the question itself allows "
      "it.\n",
      kSoughtError, 100 * audit.Seen(),
      Counted(static_cast<std::size_t>(audit.passing), "length finding"), audit.excusable,
      audit.tolerated);
  out << fmt::format("{} with {} hide {}",
                     Counted(ledger.entries.size(), "entry", "entries"),
                     Counted(ledger.bounds.size(), "bound"),
                     Counted(static_cast<std::size_t>(audit.hidden), "finding"));
  if (!ledger.entries.empty()) {
    out << fmt::format(
        "; the first expires on {}",
        std::ranges::min(ledger.entries, {}, &LedgerEntry::expires).expires);
  }
  out << '\n';
  WriteLarge(audit, out);
  WriteContradictions(report, audit, out);
  WriteEntries(report, out);
}

std::vector<std::string> FaultsOf(const RunReport& report, const LedgerAudit& audit) {
  std::vector<std::string> faults;
  if (audit.Seen() < kLeastSeen) {
    faults.push_back(fmt::format(
        "{}: would excuse an error of {:g} of the scene in {} of {} passing cells; "
        "expected at most {:.1f} %",
        report.ledger.file.filename().string(), kSoughtError, audit.excusable,
        audit.passing, 100 * (1 - kLeastSeen)));
  }
  for (const LedgerAudit::Contradiction& contradiction : audit.contradictions)
    faults.push_back(SentenceOf(report, contradiction));
  return faults;
}

bool IsInOrder(const LedgerAudit& audit) {
  return audit.Seen() >= kLeastSeen && audit.contradictions.empty();
}

}  // namespace touchstone
