#pragma once

#include "cli/session.h"

namespace touchstone {

/** Prints the oracles with their library, version and precision. Per pair of shapes, it
 prints the algorithm family and the parts of the answer; with `settings`, it prints the
 settings and conversions of each adapter instead. Then it prints the oracles missing from
 this build and how to install them. */
int OraclesCommand(const Session& session, bool settings);

}  // namespace touchstone
