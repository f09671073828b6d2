#pragma once

#include "cli/session.h"

namespace touchstone {

/** Runs the whole catalogue and prints a ledger entry for every failure that no entry
 accepts. A person writes their reasons. */
int LedgerCommand(const Session& session);

/** Runs the whole catalogue and prints docs/accuracy.md: the worst error of each oracle
 per pair of shapes and per world. */
int AccuracyCommand(const Session& session);

}  // namespace touchstone
