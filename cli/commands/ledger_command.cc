#include "cli/commands/ledger_command.h"

#include <iostream>

#include "cli/select_oracles.h"
#include "cli/select_scenarios.h"
#include "reports/accuracy/accuracy.h"
#include "reports/ledger/ledger_file.h"

namespace touchstone {
namespace {

RunReport RunEverything(const Session& session) {
  const OracleSelection every_oracle{.subject = session.defaults.subject, .against = {}};
  const std::vector<const Oracle*> oracles =
      SelectOracles(session.registry, every_oracle);
  const ScenarioSelection all{.patterns = {}, .catalogues = {session.catalogue()}};
  const Questions questions = SelectQuestions(all);
  return RunSuite(session, questions, oracles, BuiltInLedger(session, all, questions),
                  {});
}

}  // namespace

int LedgerCommand(const Session& session) {
  std::cout << ProposeLedger(RunEverything(session));
  return 0;
}

int AccuracyCommand(const Session& session) {
  std::cout << AccuracyTable(RunEverything(session));
  return 0;
}

}  // namespace touchstone
