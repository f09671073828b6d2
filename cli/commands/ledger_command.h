#pragma once

#include <filesystem>
#include <optional>

#include "cli/select_oracles.h"
#include "cli/select_scenarios.h"
#include "cli/session.h"

namespace touchstone {

/** The arguments of `touchstone ledger`. */
struct LedgerArguments {
  ScenarioSelection scenarios;
  OracleSelection oracles;
  std::optional<std::filesystem::path> ledger;  ///< Replaces the built-in ledger.
};

/** Runs scenarios and prints a ledger entry for every failure that no entry of the ledger
 accepts. A person writes their reasons. */
int LedgerCommand(const Session& session, const LedgerArguments& arguments);

/** Runs the whole catalogue and prints docs/accuracy.md: the worst error of each oracle
 per pair of shapes and per world. */
int AccuracyCommand(const Session& session);

}  // namespace touchstone
