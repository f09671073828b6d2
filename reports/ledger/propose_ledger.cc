#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/finding/tolerance.h"
#include "reports/ledger/ledger_file.h"

namespace touchstone {
namespace {

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
  std::set<MeasureKind> measures;
  double tolerances = 0;  ///< The worst failure, as a multiple of its tolerance.
  std::string proof;      ///< Proof of the worst failure.
};

/** A proposed entry, and the scenarios it covers. */
struct Proposal {
  Kind kind;
  std::string scenarios;
  Shown shown;
  std::size_t count = 0;
};

void Include(Shown& all, const Shown& one) {
  all.measures.insert(one.measures.begin(), one.measures.end());
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
  std::map<Kind, std::map<std::string, Shown>> failures;
  for (const Finding& finding : report.findings) {
    if (!IsFailure(finding.verdict)) continue;
    const Kind kind{finding.oracle, finding.verdict, finding.cause};
    Include(failures[kind][finding.scenario],
            {{finding.measure},
             InTolerances(finding.value, finding.tolerance),
             finding.proof});
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
    alike[{FolderOf(scenario), shown.measures}].push_back(scenario);
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
  entry.scenarios = {proposal.scenarios};
  entry.oracle = proposal.kind.oracle;
  entry.version = oracle->version;
  entry.verdict = proposal.kind.verdict;
  entry.measures.assign(proposal.shown.measures.begin(), proposal.shown.measures.end());
  // An unproved difference has no cause yet: it is a defect until somebody knows better.
  entry.causes = {proposal.kind.cause == Cause::kNone ? Cause::kDefect
                                                      : proposal.kind.cause};
  entry.upstream = "unreported";
  entry.expires = expires;
  return entry;
}

}  // namespace

std::string CauseLine(std::span<const Cause> causes) {
  std::vector<std::string> names;
  for (const Cause cause : causes) names.push_back(Quoted(NameOf(cause)));
  return names.size() == 1 ? fmt::format("cause = {}", names[0])
                           : fmt::format("cause = [{}]", fmt::join(names, ", "));
}

std::string WriteLedgerEntry(const LedgerEntry& entry, std::string_view comment) {
  std::vector<std::string> globs;
  for (const std::string& glob : entry.scenarios) globs.push_back(Quoted(glob));
  std::vector<std::string> measures;
  for (const MeasureKind measure : entry.measures)
    measures.push_back(Quoted(NameOf(measure)));
  std::string text;
  if (!comment.empty()) text += fmt::format("# {}\n", comment);
  text += globs.size() == 1
              ? fmt::format("[[entry]]\nscenarios = {}\n", globs[0])
              : fmt::format("[[entry]]\nscenarios = [{}]\n", fmt::join(globs, ", "));
  text += fmt::format("oracle = {}\nversion = {}\nverdict = {}\nmeasures = [{}]\n",
                      Quoted(entry.oracle), Quoted(entry.version),
                      Quoted(NameOf(entry.verdict)), fmt::join(measures, ", "));
  text += fmt::format("{}\n", CauseLine(entry.causes));
  if (entry.responsible != Responsible::kEngine)
    text += fmt::format("responsible = {}\n", Quoted(NameOf(entry.responsible)));
  text += fmt::format(
      "{}reason = {}\nupstream = {}\nexpires = {}\n",
      entry.fault.empty() ? "" : fmt::format("fault = {}\n", Quoted(entry.fault)),
      Quoted(entry.reason), Quoted(entry.upstream),
      entry.expires.empty() ? "\"\"" : entry.expires);
  if (entry.intermittent) text += "intermittent = true\n";
  if (entry.beyond_scene) text += "beyond_scene = true\n";
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
