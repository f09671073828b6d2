#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "cli/command_line.h"
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

/** Reads a ledger; throws InputError with all its errors. Without `file`, the default
 one, or an empty one where that is not there. */
Ledger LoadLedger(const Session& session,
                  const std::optional<std::filesystem::path>& file);

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
