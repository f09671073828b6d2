#pragma once

#include <string>
#include <vector>

#include "cli/session.h"

namespace touchstone {

/** Checks the oracle of which `words` is the name, else the program and its arguments,
 and prints what is wrong with it. Returns the exit code. */
int CheckOracleCommand(const Session& session, const std::vector<std::string>& words);

}  // namespace touchstone
