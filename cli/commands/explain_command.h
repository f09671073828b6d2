#pragma once

#include "cli/select_oracles.h"
#include "cli/select_scenarios.h"
#include "cli/session.h"

namespace touchstone {

/** Prints, for one selected scenario, the certified truth, the oracles that are proved
 right and wrong, and every oracle's answer side by side; with `everything`, also the
 scenario file and every number. For several scenarios, prints one line each. */
int ExplainCommand(const Session& session, const ScenarioSelection& scenarios,
                   const OracleSelection& oracles, bool everything);

/** The arguments of `touchstone ask`. */
struct AskArguments {
  std::string A;  ///< In the syntax of cli/body_text.h.
  std::string B;
  OracleSelection oracles;
  std::string id = "ask";   ///< Id of the scenario.
  bool toml = false;        ///< Print the question as a scenario file, query no oracle.
  bool everything = false;  ///< Same as for ExplainCommand().
};

/** Same as ExplainCommand(), for two shapes given on the command line. */
int AskCommand(const Session& session, const AskArguments& arguments);

}  // namespace touchstone
