#include "cli/commands/reproduce_command.h"

#include <iostream>

#include <fmt/format.h>

#include "cli/input_error.h"
#include "cli/output_folder.h"
#include "reports/reproduce/engine_code.h"
#include "reports/reproduce/reproduction.h"
#include "reports/writers/outcome.h"

namespace touchstone {
namespace {

/** Refuses a world before it is simulated. */
void RefuseWorld(const ScenarioSelection& selection) {
  const Questions questions = SelectQuestions(selection);
  if (!questions.contacts.empty() || questions.worlds.size() != 1) return;
  throw InputError(fmt::format(
      "{} is a world; expected a contact query: programs for worlds are not supported",
      IdOf(questions.worlds.front())));
}

Reproduction FilesOf(const ChosenFault& fault) {
  try {
    return Reproduce(fault.report.scenarios.front(), fault.oracle->info(), fault.finding);
  } catch (const CannotReproduce& error) {
    throw InputError(
        fmt::format("{} cannot be reproduced: {}", IdOf(fault.question), error.what()));
  }
}

}  // namespace

int ReproduceCommand(const Session& session, const ReproduceArguments& arguments) {
  RefuseWorld(arguments.fault.scenarios);
  const ChosenFault fault = ChooseFault(session, arguments.fault);
  const Reproduction files = FilesOf(fault);
  const OutputFolder folder(arguments.out);
  folder.Write("reproduce.cc", [&](std::ostream& out) { out << files.program; });
  folder.Write("CMakeLists.txt", [&](std::ostream& out) { out << files.build; });
  folder.Write("REPORT.md", [&](std::ostream& out) { out << files.report; });
  const std::string path = arguments.out.string();
  std::cout << fmt::format(
      "{0}\nWrote reproduce.cc, CMakeLists.txt and REPORT.md to {1}/. Nothing was built. "
      "Next:\n  cmake -S {1} -B {1}/build && cmake --build {1}/build && "
      "{1}/build/reproduce\n",
      Sentence(fault.finding), path);
  return 0;
}

}  // namespace touchstone
