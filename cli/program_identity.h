#pragma once

#include <string>

namespace touchstone {

/** Returns a text that differs for every build of the running program and of the
 libraries that it has loaded: a hash of its file, and of their paths, sizes and times. */
std::string ProgramIdentity();

}  // namespace touchstone
