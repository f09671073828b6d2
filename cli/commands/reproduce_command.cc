#include "cli/commands/reproduce_command.h"

#include <algorithm>
#include <iostream>
#include <vector>

#include <fmt/format.h>

#include "cli/input_error.h"
#include "cli/output_folder.h"
#include "reports/reproduce/engine_code.h"
#include "reports/reproduce/reproduction.h"
#include "reports/writers/outcome.h"

namespace touchstone {
namespace {

/** The files for one finding of a fault. */
struct Written {
  Reproduction files;
  const Finding* finding;
};

/** Returns the motion of the fault with a sample at every step. Some laws also judge the
 steps between two samples. */
WorldResult OfEveryStep(const ChosenFault& fault) {
  WorldResult result = fault.report.worlds.front();
  result.scenario.world.sample_every = 1;
  result.trajectories.front() = fault.oracle->Simulate(result.scenario.world);
  return result;
}

Reproduction FilesOf(const ChosenFault& fault, const Finding& finding) {
  const OracleInfo& oracle = fault.oracle->info();
  if (std::holds_alternative<WorldScenario>(fault.question)) {
    const WorldResult& sampled = fault.report.worlds.front();
    try {
      return Reproduce(sampled, oracle, finding);
    } catch (const CannotReproduce&) {
      if (sampled.scenario.world.sample_every == 1) throw;
      return Reproduce(OfEveryStep(fault), oracle, finding);
    }
  }
  return Reproduce(fault.report.scenarios.front(), oracle, finding);
}

/** Returns the files for the chosen finding or, if no program can check it, for the
 gravest of the others: of the same measure, if the user named one. */
Written FilesOf(const ChosenFault& fault, bool is_measure_named) {
  std::vector<const Finding*> candidates = {&fault.finding};
  for (const Finding& finding : fault.report.findings) {
    const bool is_eligible =
        !is_measure_named || finding.measure == fault.finding.measure;
    if (is_eligible && IsFailure(finding.verdict)) candidates.push_back(&finding);
  }
  std::stable_sort(
      candidates.begin() + 1, candidates.end(),
      [](const Finding* a, const Finding* b) { return a->grade > b->grade; });
  std::string reason;
  for (const Finding* const finding : candidates) {
    try {
      return {FilesOf(fault, *finding), finding};
    } catch (const CannotCheck& error) {
      if (reason.empty()) {
        reason = fmt::format("{}; choose one that the answer fails with --measure",
                             error.what());
      }
    } catch (const CannotReproduce& error) {
      if (reason.empty()) reason = error.what();
    }
  }
  throw InputError(
      fmt::format("{} cannot be reproduced: {}", IdOf(fault.question), reason));
}

}  // namespace

int ReproduceCommand(const Session& session, const ReproduceArguments& arguments) {
  const ChosenFault fault = ChooseFault(session, arguments.fault);
  const Written written = FilesOf(fault, arguments.fault.names_a_measure());
  const OutputFolder folder(arguments.out);
  folder.Write("reproduce.cc", [&](std::ostream& out) { out << written.files.program; });
  folder.Write("CMakeLists.txt", [&](std::ostream& out) { out << written.files.build; });
  folder.Write("REPORT.md", [&](std::ostream& out) { out << ReportFile(written.files); });
  const std::string path = arguments.out.string();
  std::cout << fmt::format(
      "{0}\nWrote reproduce.cc, CMakeLists.txt and REPORT.md to {1}/. Nothing was built. "
      "Next:\n  cmake -S {1} -B {1}/build && cmake --build {1}/build && "
      "{1}/build/reproduce\n",
      Sentence(*written.finding), path);
  return 0;
}

}  // namespace touchstone
