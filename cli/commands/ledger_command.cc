#include "cli/commands/ledger_command.h"

#include <iostream>

#include "reports/accuracy/accuracy.h"
#include "reports/ledger/ledger_file.h"

namespace touchstone {
namespace {

RunReport RunAll(const Session& session, const LedgerArguments& arguments) {
  const std::vector<const Oracle*> oracles =
      SelectOracles(session.registry, arguments.oracles);
  const Questions questions = SelectQuestions(arguments.scenarios);
  const Ledger ledger = arguments.ledger
                            ? ReadLedgerOf(*arguments.ledger)
                            : BuiltInLedger(session, arguments.scenarios, questions);
  return RunSuite(session, questions, oracles, ledger,
                  {.partial = !arguments.scenarios.patterns.empty()});
}

}  // namespace

int LedgerCommand(const Session& session, const LedgerArguments& arguments) {
  std::cout << ProposeLedger(RunAll(session, arguments));
  return 0;
}

int AccuracyCommand(const Session& session) {
  const LedgerArguments everything{
      .scenarios = {.patterns = {}, .catalogues = {session.catalogue()}},
      .oracles = {.subject = session.defaults.subject, .tolerance = {}, .against = {}},
      .ledger = {}};
  std::cout << AccuracyTable(RunAll(session, everything));
  return 0;
}

}  // namespace touchstone
