#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "cli/select_scenarios.h"
#include "cli/terminal.h"
#include "oracles/oracle_registry.h"
#include "reports/run.h"

namespace touchstone {

/** The state that every command uses. */
struct Session {
  OracleRegistry registry;
  std::string default_subject;  ///< Same as CommandLineDefaults::subject.
  std::filesystem::path data;   ///< Same as CommandLineDefaults::data.
  Terminal terminal;

  std::filesystem::path catalogue() const { return data / "catalogue"; }
};

/** Reads a ledger file. Throws InputError with all its errors. */
Ledger ReadLedgerOf(const std::filesystem::path& file);

/** Returns the built-in ledger, or an empty one if the file does not exist. It applies to
 the scenarios of the built-in catalogue only. All other `questions`, as selected by
 `selection`, become its `outside_catalogue`, even where their ids match an entry. Throws
 InputError. */
Ledger BuiltInLedger(const Session& session, const ScenarioSelection& selection,
                     const Questions& questions);

/** Options for running scenarios. */
struct SuiteOptions {
  int jobs = 0;               ///< Same as RunOptions::jobs.
  bool partial = false;       ///< Same as RunOptions::partial.
  bool quiet = false;         ///< No progress bar.
  Stop stop = nullptr;        ///< Same as RunOptions::stop.
  WorldsOptions worlds = {};  ///< Same as RunOptions::worlds.
};

/** Runs the questions on the oracles and shows a progress bar. Ledger entries expire
 against today's date. */
RunReport RunSuite(const Session& session, const Questions& questions,
                   std::span<const Oracle* const> oracles, const Ledger& ledger,
                   const SuiteOptions& options);

}  // namespace touchstone
