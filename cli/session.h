#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "cli/command_line.h"
#include "cli/select_scenarios.h"
#include "cli/terminal.h"
#include "reports/run.h"

namespace touchstone {

/** What every command works with. */
struct Session {
  OracleRegistry registry;
  CommandLineDefaults defaults;
  Terminal terminal;

  std::filesystem::path catalogue() const { return defaults.data / "catalogue"; }
};

/** Reads a ledger; throws InputError with all its errors. */
Ledger ReadLedgerOf(const std::filesystem::path& file);

/** Returns the built-in ledger, or an empty one where it is not there. It is about the
 scenarios of the built-in catalogue: those of `questions`, as selected by `selection`,
 that are not of it are strangers to it, though their ids look alike. Throws InputError.
 */
Ledger BuiltInLedger(const Session& session, const ScenarioSelection& selection,
                     const Questions& questions);

/** How a command runs scenarios. */
struct SuiteOptions {
  int jobs = 0;          ///< As RunOptions::jobs.
  bool partial = false;  ///< As RunOptions::partial.
  bool quiet = false;    ///< No progress bar.
};

/** Puts the questions with a progress bar, as of today. */
RunReport RunSuite(const Session& session, const Questions& questions,
                   std::span<const Oracle* const> oracles, const Ledger& ledger,
                   const SuiteOptions& options);

}  // namespace touchstone
