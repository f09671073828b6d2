#include "cli/commands/simulate_command.h"

#include <fstream>
#include <iostream>

#include <fmt/format.h>

#include "cli/input_error.h"
#include "cli/select_oracles.h"
#include "reports/writers/trajectory_csv.h"

namespace touchstone {
namespace {

std::vector<const Oracle*> Simulating(const Session& session,
                                      const std::vector<std::string>& names) {
  std::vector<const Oracle*> oracles;
  if (names.empty()) oracles = session.registry.All();
  for (const std::string& name : names) {
    for (const Oracle* oracle : OraclesNamed(session.registry, name))
      oracles.push_back(oracle);
  }
  std::erase_if(oracles, [](const Oracle* oracle) { return !oracle->info().simulates; });
  if (oracles.empty())
    throw InputError(
        "none of these oracles simulates worlds; `touchstone oracles` shows "
        "which do");
  return oracles;
}

void Simulate(const WorldScenario& scenario, const Oracle& oracle, std::ostream& out,
              int& whole, int& broken) {
  const Trajectory trajectory = oracle.Simulate(scenario.world);
  const std::string& name = oracle.info().name;
  const auto tell = [&](std::string_view what) {
    std::cerr << fmt::format("touchstone: {}: {}: {}\n", scenario.id, name, what);
  };
  if (trajectory.status == AnswerStatus::kUnsupported) {
    tell("unsupported, " + trajectory.reason);
    return;
  }
  WriteTrajectory(scenario, name, trajectory, out);
  if (trajectory.status != AnswerStatus::kAnswered) {
    tell(trajectory.reason);
    ++broken;
  } else if (trajectory.diverged_at_step != 0) {
    tell(fmt::format("diverged in step {}", trajectory.diverged_at_step));
    ++broken;
  } else {
    ++whole;
  }
}

}  // namespace

int SimulateCommand(const Session& session, const SimulateArguments& arguments) {
  const std::vector<const Oracle*> oracles = Simulating(session, arguments.oracles);
  const Questions questions = SelectQuestions(arguments.scenarios);
  if (questions.worlds.empty())
    throw InputError(
        "the selected scenarios are contact queries; expected worlds (see `touchstone "
        "explain` for contact queries)");
  std::ofstream file;
  const bool to_file = arguments.csv && *arguments.csv != "-";
  if (to_file) {
    file.open(*arguments.csv, std::ios::binary);
    if (!file) throw InputError(fmt::format("cannot write {}", arguments.csv->string()));
  }
  std::ostream& out = to_file ? file : std::cout;
  WriteTrajectoryHeader(out);
  int whole = 0;
  int broken = 0;
  for (const WorldScenario& scenario : questions.worlds) {
    for (const Oracle* oracle : oracles) Simulate(scenario, *oracle, out, whole, broken);
  }
  out.flush();
  if (!out) throw InputError("the table could not be written completely");
  if (broken > 0) return 1;
  return whole > 0 ? 0 : 2;
}

}  // namespace touchstone
