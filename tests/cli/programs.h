#pragma once

#include <string>

namespace touchstone {

/** Returns the path of the program itself. */
std::string TouchstoneProgram();

/** Returns the path of program_with_faults, which has oracles with known faults. */
std::string ProgramWithFaults();

}  // namespace touchstone
