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

Reproduction FilesOf(const ChosenFault& fault) {
  const std::string& id = IdOf(fault.question);
  if (fault.report.scenarios.empty()) {
    throw InputError(fmt::format(
        "{} is a world; expected a contact query: programs for worlds are not supported",
        id));
  }
  try {
    return Reproduce(fault.report.scenarios.front(), fault.oracle->info(), fault.finding);
  } catch (const CannotReproduce& error) {
    throw InputError(fmt::format("{} cannot be reproduced: {}", id, error.what()));
  }
}

}  // namespace

int ReproduceCommand(const Session& session, const ReproduceArguments& arguments) {
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
