#pragma once

#include <filesystem>
#include <optional>

#include "cli/select_oracles.h"
#include "cli/select_scenarios.h"
#include "cli/session.h"

namespace touchstone {

/** The arguments of `touchstone run`. */
struct RunArguments {
  ScenarioSelection scenarios;
  OracleSelection oracles;
  std::optional<std::filesystem::path> ledger;  ///< Replaces the built-in ledger.
  /** The report.jsonl of an earlier run. A finding that got worse fails this run. */
  std::optional<std::filesystem::path> baseline;
  /** The published table of accuracy, docs/accuracy.md: the run is audited, too. */
  std::optional<std::filesystem::path> audit;
  std::optional<std::filesystem::path>
      out;  ///< Folder for the page, its data, the JSON Lines and the JUnit file.
  /** Whether results that an interrupted run left in `out` are used. */
  bool resume = false;
  bool open = false;  ///< Whether to show the page in the browser.
  FailureRule rule = {};
  int jobs = 0;
  bool timings = false;  ///< Whether to print where the time went.
  bool quiet = false;
};

/** Runs scenarios on oracles, prints the findings and writes the reports. Returns the
 exit code of the run. */
int RunCommand(const Session& session, const RunArguments& arguments);

}  // namespace touchstone
