#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/select_scenarios.h"
#include "cli/session.h"

namespace touchstone {

struct SimulateArguments {
  ScenarioSelection scenarios;
  std::vector<std::string> oracles;  ///< Names or groups; empty: all that simulate.
  std::optional<std::filesystem::path> csv;  ///< Empty: standard output.
};

/** Writes the motion of each selected world by each oracle as CSV, a row for each sample
 and thing. Returns 0; 1 where an oracle that can simulate a world gave no motion to its
 end; 2 where no world was simulated. */
int SimulateCommand(const Session& session, const SimulateArguments& arguments);

}  // namespace touchstone
