#pragma once

#include <string>

namespace touchstone {

/** Returns the path of the program. */
std::string TouchstoneProgram();

}  // namespace touchstone
