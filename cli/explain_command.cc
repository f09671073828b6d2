#include "cli/explain_command.h"

#include <iostream>

#include <fmt/format.h>

#include "cli/body_text.h"
#include "cli/input_error.h"
#include "reports/writers/explanation_writer.h"
#include "scenarios/scenario_file.h"
#include "scenarios/validate.h"

namespace touchstone {
namespace {

int Explain(const Session& session, std::span<const Scenario> scenarios,
            const OracleSelection& selection, const Ledger& ledger) {
  const std::vector<const Oracle*> oracles = SelectOracles(session.registry, selection);
  const RunReport report =
      RunSuite(session, scenarios, oracles, ledger, {.partial = true});
  WriteExplanation(report, std::cout);
  return 0;
}

}  // namespace

int ExplainCommand(const Session& session, const ScenarioSelection& selection,
                   const OracleSelection& oracles) {
  const std::vector<Scenario> scenarios = SelectScenarios(selection);
  for (const Scenario& scenario : scenarios) std::cout << WriteScenario(scenario) << '\n';
  return Explain(session, scenarios, oracles, LoadLedger(session, {}));
}

int AskCommand(const Session& session, const AskArguments& arguments) {
  Scenario scenario;
  scenario.id = "ask";
  scenario.title = "a question from the command line";
  scenario.source = "the command line";
  scenario.name_A = "A";
  scenario.name_B = "B";
  scenario.contact = {ParseBody(arguments.A), ParseBody(arguments.B)};
  std::string faults;
  for (const Fault& fault : FaultsOf(scenario.contact)) {
    faults +=
        fmt::format("{} {}, expected {}\n", fault.where, fault.what, fault.expected);
  }
  if (!faults.empty()) throw InputError(faults + "the question has no answer");
  // No entry of the ledger is about this question.
  return Explain(session, std::span(&scenario, 1), arguments.oracles, {});
}

}  // namespace touchstone
