#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/ledger/apply_ledger.h"
#include "reports/ledger/ledger_file.h"

namespace touchstone {
namespace {

bool HasValue(Verdict verdict) {
  return verdict == Verdict::kFail || verdict == Verdict::kDisagree;
}

std::string FolderOf(const std::string& id) {
  return id.substr(0, id.rfind('/'));
}

/** The properties that the failures of one entry share. */
struct Kind {
  std::string oracle;
  Verdict verdict;
  Cause cause;
  auto operator<=>(const Kind&) const = default;
};

/** The failures of one kind in one scenario. */
struct Shown {
  std::map<MeasureKind, double> worst;
  double tolerances = 0;  ///< The worst failure, as a multiple of its tolerance.
  std::string proof;      ///< Proof of the worst failure.

  std::set<MeasureKind> Measures() const {
    std::set<MeasureKind> measures;
    for (const auto& [measure, value] : worst) measures.insert(measure);
    return measures;
  }
};

/** A proposed entry, and the scenarios it covers. */
struct Proposal {
  Kind kind;
  std::string scenarios;
  Shown shown;
  std::size_t count = 0;
};

void Include(Shown& all, const Shown& one) {
  for (const auto& [measure, value] : one.worst) {
    double& worst = all.worst[measure];
    worst = std::max(worst, value);
  }
  if (!all.proof.empty() && one.tolerances <= all.tolerances) return;
  all.tolerances = one.tolerances;
  all.proof = one.proof;
}

std::string Quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

/** The scenarios that each oracle answers or ought to answer, keyed by oracle and folder.
 */
using Folders = std::map<std::pair<std::string, std::string>, std::set<std::string>>;

Folders AnsweredFolders(const RunReport& report) {
  Folders folders;
  for (const Finding& finding : report.findings) {
    if (finding.verdict == Verdict::kUnsupported) continue;
    folders[{finding.oracle, FolderOf(finding.scenario)}].insert(finding.scenario);
  }
  return folders;
}

std::map<Kind, std::map<std::string, Shown>> FailuresOf(const RunReport& report) {
  const std::map<std::string_view, LedgerScale> scales = LedgerScalesOf(report);
  std::map<Kind, std::map<std::string, Shown>> failures;
  for (const Finding& finding : report.findings) {
    if (!IsFailure(finding.verdict)) continue;
    const Kind kind{finding.oracle, finding.verdict, finding.cause};
    const double value = ValueForLedger(finding, scales.at(finding.scenario));
    Include(
        failures[kind][finding.scenario],
        {{{finding.measure, value}}, finding.value / finding.tolerance, finding.proof});
  }
  return failures;
}

/** Groups the failures of one kind. If all scenarios of a folder fail alike, they become
 one proposal. */
std::vector<Proposal> Grouped(const Kind& kind,
                              const std::map<std::string, Shown>& failures,
                              const Folders& folders) {
  std::map<std::pair<std::string, std::set<MeasureKind>>, std::vector<std::string>> alike;
  for (const auto& [scenario, shown] : failures) {
    alike[{FolderOf(scenario), shown.Measures()}].push_back(scenario);
  }
  std::vector<Proposal> proposals;
  for (const auto& [key, scenarios] : alike) {
    const std::string& folder = key.first;
    const bool all = scenarios.size() > 1 &&
                     scenarios.size() == folders.at({kind.oracle, folder}).size();
    if (all) proposals.push_back({kind, folder + "/*", {}, 0});
    for (const std::string& scenario : scenarios) {
      if (!all) proposals.push_back({kind, scenario, {}, 0});
      Include(proposals.back().shown, failures.at(scenario));
      ++proposals.back().count;
    }
  }
  return proposals;
}

LedgerEntry EntryOf(const Proposal& proposal, const RunReport& report,
                    std::string_view expires) {
  const auto oracle = std::find_if(
      report.oracles.begin(), report.oracles.end(),
      [&](const OracleInfo& info) { return info.name == proposal.kind.oracle; });
  LedgerEntry entry;
  entry.scenarios = proposal.scenarios;
  entry.oracle = proposal.kind.oracle;
  entry.version = oracle->version;
  entry.verdict = proposal.kind.verdict;
  for (const auto& [measure, worst] : proposal.shown.worst) {
    const double bound =
        HasValue(entry.verdict) ? RoundedUp(kProposedBound * worst) : 0.0;
    entry.accepted.push_back({measure, IsShare(measure) ? std::min(bound, 1.0) : bound});
  }
  // An unproved difference has no cause yet: it is a defect until somebody knows better.
  entry.cause =
      proposal.kind.cause == Cause::kNone ? Cause::kDefect : proposal.kind.cause;
  entry.upstream = "unreported";
  entry.expires = expires;
  return entry;
}

}  // namespace

bool IsShare(MeasureKind measure) {
  return measure == MeasureKind::kPatchCoverage || measure == MeasureKind::kAnswering ||
         measure == MeasureKind::kDeterminism;
}

double RoundedUp(double value) {
  if (!(value > 0)) return 0;
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return std::ceil(value / digit) * digit;
}

std::string WriteLedgerEntry(const LedgerEntry& entry, std::string_view comment) {
  std::vector<std::string> accepted;
  for (const Accepted& of : entry.accepted) {
    accepted.push_back(HasValue(entry.verdict)
                           ? fmt::format("{} = {:.6g}", NameOf(of.measure), of.bound)
                           : Quoted(NameOf(of.measure)));
  }
  std::string text;
  if (!comment.empty()) text += fmt::format("# {}\n", comment);
  text +=
      fmt::format("[[entry]]\nscenarios = {}\noracle = {}\nversion = {}\n",
                  Quoted(entry.scenarios), Quoted(entry.oracle), Quoted(entry.version));
  text += fmt::format("verdict = {}\n", Quoted(NameOf(entry.verdict)));
  text += HasValue(entry.verdict)
              ? fmt::format("bounds = {{ {} }}\n", fmt::join(accepted, ", "))
              : fmt::format("measures = [{}]\n", fmt::join(accepted, ", "));
  text +=
      fmt::format("cause = {}\nreason = {}\nupstream = {}\nexpires = {}\n",
                  Quoted(NameOf(entry.cause)), Quoted(entry.reason),
                  Quoted(entry.upstream), entry.expires.empty() ? "\"\"" : entry.expires);
  return text;
}

std::string ProposeLedger(const RunReport& report, std::string_view expires) {
  const Folders folders = AnsweredFolders(report);
  std::string text;
  for (const auto& [kind, failures] : FailuresOf(report)) {
    for (const Proposal& proposal : Grouped(kind, failures, folders)) {
      std::string comment = proposal.shown.proof;
      std::replace(comment.begin(), comment.end(), '\n', ' ');
      if (proposal.count > 1) {
        comment = fmt::format("{} scenarios; the worst: {}", proposal.count, comment);
      }
      if (!text.empty()) text += '\n';
      text += WriteLedgerEntry(EntryOf(proposal, report, expires), comment);
    }
  }
  return text;
}

}  // namespace touchstone
