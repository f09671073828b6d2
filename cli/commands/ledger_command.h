#pragma once

#include "cli/session.h"

namespace touchstone {

/** Runs the whole catalogue and prints ledger entries for every failure that none
 excuses, their reasons left for a person to write. */
int LedgerCommand(const Session& session);

/** Runs the whole catalogue and prints docs/accuracy.md, the worst error per oracle and
 pair of shapes. */
int AccuracyCommand(const Session& session);

}  // namespace touchstone
