#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/select_scenarios.h"
#include "cli/session.h"

namespace touchstone {

/** The arguments of `touchstone simulate`. */
struct SimulateArguments {
  ScenarioSelection scenarios;
  std::vector<std::string> oracles;  ///< Names or groups; empty: all that simulate.
  std::optional<std::filesystem::path> csv;  ///< Empty: standard output.
};

/** Writes the motion of each selected world by each oracle as CSV, with a row for each
 sample and moving object. Returns 0; 1 if an oracle that supports a world did not
 simulate it to the end; 2 if no world was simulated. */
int SimulateCommand(const Session& session, const SimulateArguments& arguments);

}  // namespace touchstone
