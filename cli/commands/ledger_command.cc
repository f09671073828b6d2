#include "cli/commands/ledger_command.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include "cli/input_error.h"
#include "reports/accuracy/accuracy.h"
#include "reports/ledger/apply_ledger.h"
#include "reports/ledger/audit_ledger.h"
#include "reports/ledger/bounds_file.h"
#include "reports/ledger/ledger_file.h"
#include "reports/ledger/rewrite_causes.h"
#include "reports/ledger/update_bounds.h"
#include "reports/text/counted.h"

namespace touchstone {
namespace {

/** Returns whether a run leaves out scenarios or oracles. */
bool IsPartial(const Session& session, const LedgerArguments& arguments) {
  return !arguments.scenarios.patterns.empty() || !arguments.oracles.against.empty() ||
         arguments.scenarios.catalogues != std::vector{session.catalogue()};
}

RunReport RunAll(const Session& session, const LedgerArguments& arguments) {
  const std::vector<const Oracle*> oracles =
      SelectOracles(session.registry, arguments.oracles);
  const Questions questions = SelectQuestions(arguments.scenarios);
  const Ledger ledger = arguments.ledger
                            ? ReadLedgerOf(*arguments.ledger)
                            : BuiltInLedger(session, arguments.scenarios, questions);
  return RunSuite(session, questions, oracles, ledger,
                  {.partial = IsPartial(session, arguments)});
}

void WriteFile(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) {
    throw InputError(fmt::format("cannot write {}; expected a file that can be written",
                                 file.string()));
  }
}

/** Writes the causes found into the report's ledger. */
void UpdateCauses(const RunReport& report) {
  const std::filesystem::path& file = report.ledger.file;
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  const std::string rewritten = RewriteCauses(text.str(), report);
  if (rewritten == text.str()) return;
  WriteFile(file, rewritten);
  std::cout << fmt::format(
      "{}: causes rewritten; see in its diff whether the reasons still fit\n",
      file.string());
}

/** Writes the bounds that the report needs to their file, and prints what changed. */
int Update(RunReport report, bool causes) {
  const UpdatedBounds updated = UpdateBounds(report);
  const std::filesystem::path file = BoundsFileOf(report.ledger.file);
  WriteFile(file, WriteBounds(updated.bounds, report.ledger.file.filename().string()));
  std::cout << fmt::format("{}: {}; {} added, {} changed, {} removed\n", file.string(),
                           Counted(updated.bounds.size(), "bound"), updated.added,
                           updated.changed, updated.removed);
  if (causes) {
    report.ledger.bounds = updated.bounds;
    ApplyAgain(report);
    UpdateCauses(report);
  }
  if (updated.uncovered == 0) return 0;
  std::cout << fmt::format(
      "No entry covers {}: `touchstone ledger --propose` prints entries for them.\n",
      Counted(updated.uncovered, "failure"));
  return 1;
}

int Audit(const RunReport& report, bool partial) {
  const LedgerAudit audit = AuditLedger(report, partial);
  WriteAudit(report, audit, std::cout);
  const auto failures = std::ranges::count_if(
      report.findings, [](const Finding& finding) { return IsFailure(finding.verdict); });
  std::cout << fmt::format("\n{} outside the ledger\n",
                           Counted(static_cast<std::uint64_t>(failures), "failure"));
  for (const std::string& fault : report.faults) std::cout << fault << '\n';
  return IsInOrder(audit) && failures == 0 && report.faults.empty() ? 0 : 1;
}

}  // namespace

int LedgerCommand(const Session& session, const LedgerArguments& arguments) {
  const RunReport report = RunAll(session, arguments);
  if (arguments.action != LedgerAction::kPropose && report.ledger.file.empty()) {
    throw InputError("no ledger; expected --ledger FILE");
  }
  switch (arguments.action) {
    case LedgerAction::kPropose:
      std::cout << ProposeLedger(report);
      return 0;
    case LedgerAction::kUpdate:
      if (arguments.causes && !arguments.ledger && IsPartial(session, arguments)) {
        throw InputError(
            "--causes of a part of the catalogue would drop those of the rest of the "
            "built-in ledger; expected no patterns and no --against");
      }
      return Update(report, arguments.causes);
    case LedgerAction::kAudit:
      return Audit(report, IsPartial(session, arguments));
  }
  return 0;
}

int AccuracyCommand(const Session& session) {
  const LedgerArguments everything{
      .action = LedgerAction::kPropose,
      .causes = false,
      .scenarios = {.patterns = {}, .catalogues = {session.catalogue()}},
      .oracles = {.subject = session.default_subject, .tolerance = {}, .against = {}},
      .ledger = {}};
  std::cout << AccuracyTable(RunAll(session, everything));
  return 0;
}

}  // namespace touchstone
