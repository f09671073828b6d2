#pragma once

#include <filesystem>
#include <optional>

#include "cli/select_oracles.h"
#include "cli/select_scenarios.h"
#include "cli/session.h"

namespace touchstone {

/** The action of `touchstone ledger`. */
enum class LedgerAction {
  kPropose,  ///< Prints entries for failures that no entry covers.
  kUpdate,   ///< Writes the file of bounds.
  kAudit,    ///< Prints what the ledger hides, and could hide.
};

/** The arguments of `touchstone ledger`. */
struct LedgerArguments {
  LedgerAction action = LedgerAction::kPropose;
  bool causes = false;  ///< Whether an update also writes the causes found.
  ScenarioSelection scenarios;
  OracleSelection oracles;
  std::optional<std::filesystem::path> ledger;  ///< Replaces the built-in ledger.
};

/** Runs scenarios and does what `arguments` say. A person writes the reasons of proposed
 entries. Returns 1 if an update left failures without an entry; or if an audit is not
 in order, see IsInOrder(), or has found failures outside the ledger or faults. Throws
 InputError. */
int LedgerCommand(const Session& session, const LedgerArguments& arguments);

/** Runs the whole catalogue and prints docs/accuracy.md: the worst error of each oracle
 per pair of shapes and per world. */
int AccuracyCommand(const Session& session);

}  // namespace touchstone
