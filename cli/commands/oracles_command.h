#pragma once

#include "cli/session.h"

namespace touchstone {

/** Prints who can answer what: library, version, precision, algorithm family and what it
 gives per pair of shapes; with `settings`, what each adapter sets and converts; and the
 oracles that this build lacks, with how to get them. */
int OraclesCommand(const Session& session, bool settings);

}  // namespace touchstone
