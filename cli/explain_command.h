#pragma once

#include "cli/select_oracles.h"
#include "cli/select_scenarios.h"
#include "cli/session.h"

namespace touchstone {

/** Prints, for one selected scenario, its file, the certified truth, every oracle's
 answer side by side, and who is proved right and wrong; for several a line each. */
int ExplainCommand(const Session& session, const ScenarioSelection& scenarios,
                   const OracleSelection& oracles);

/** The arguments of `touchstone ask`. */
struct AskArguments {
  std::string A;  ///< In the syntax of cli/body_text.h.
  std::string B;
  OracleSelection oracles;
  std::string id = "ask";  ///< Of the scenario.
  bool toml = false;       ///< Print the question as a scenario file, and ask nobody.
};

/** As ExplainCommand(), for two shapes given on the command line. */
int AskCommand(const Session& session, const AskArguments& arguments);

}  // namespace touchstone
