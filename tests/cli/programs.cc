#include "programs.h"

namespace touchstone {

std::string TouchstoneProgram() {
  return TOUCHSTONE_PROGRAM;
}

std::string ProgramWithFaults() {
  return PROGRAM_WITH_FAULTS;
}

}  // namespace touchstone
