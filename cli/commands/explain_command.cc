#include "cli/commands/explain_command.h"

#include <iostream>

#include <fmt/format.h>

#include "cli/body_text.h"
#include "cli/input_error.h"
#include "reports/writers/explanation_writer.h"
#include "scenarios/scenario_file.h"
#include "scenarios/validate_scenario.h"

namespace touchstone {
namespace {

RunReport Answers(const Session& session, const Questions& questions,
                  const OracleSelection& selection, const Ledger& ledger) {
  const std::vector<const Oracle*> oracles = SelectOracles(session.registry, selection);
  return RunSuite(session, questions, oracles, ledger, {.partial = true});
}

}  // namespace

int ExplainCommand(const Session& session, const ScenarioSelection& selection,
                   const OracleSelection& oracles, bool everything) {
  const Questions questions = SelectQuestions(selection);
  const RunReport report =
      Answers(session, questions, oracles, BuiltInLedger(session, selection, questions));
  if (QuestionCount(report) == 1) {
    if (everything) {
      for (const Scenario& scenario : questions.contacts)
        std::cout << WriteScenario(scenario) << '\n';
      for (const WorldScenario& scenario : questions.worlds)
        std::cout << WriteScenario(scenario) << '\n';
    }
    WriteExplanation(report, {.everything = everything}, std::cout);
    if (!everything)
      std::cout << "\n--all also shows the file, every contact and every number\n";
    return 0;
  }
  WriteExplanationTable(report, std::cout);
  std::cout
      << "\nFor every answer to one scenario, with proofs: touchstone explain ID (or its "
         "file)\n";
  return 0;
}

int AskCommand(const Session& session, const AskArguments& arguments) {
  Scenario scenario;
  scenario.id = arguments.id;
  scenario.title = "A question from the command line";
  scenario.source =
      fmt::format("touchstone ask --A '{}' --B '{}'", arguments.A, arguments.B);
  scenario.name_A = 'A';
  scenario.name_B = 'B';
  scenario.contact = {ParseBody(arguments.A), ParseBody(arguments.B)};
  std::string faults;
  for (const Fault& fault : FaultsOf(scenario)) {
    faults +=
        fmt::format("{} {}, expected {}\n", fault.where, fault.what, fault.expected);
  }
  if (!faults.empty()) throw InputError(faults + "the question has no answer");
  if (arguments.toml) {
    std::cout << WriteScenario(scenario);
    return 0;
  }
  // No ledger entry applies to this question.
  WriteExplanation(Answers(session, {{scenario}, {}}, arguments.oracles, {}),
                   {.everything = arguments.everything}, std::cout);
  return 0;
}

}  // namespace touchstone
