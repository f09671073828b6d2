#include "tests/conformance/touchstone_program.h"

namespace touchstone {

std::string TouchstoneProgram() {
  return TOUCHSTONE_PROGRAM;
}

}  // namespace touchstone
