#pragma once

#include <string>

#include "cli/session.h"

namespace touchstone {

/** Answers the oracle protocol on standard input and output for the oracle `name`.
 Whatever the engine prints goes to standard error. Returns the exit code. */
int ServeCommand(const Session& session, const std::string& name);

}  // namespace touchstone
