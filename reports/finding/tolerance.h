#pragma once

#include <string>

namespace touchstone {

/** An acceptable error, and the argument for it. */
struct Tolerance {
  double value = 0;
  std::string because;  ///< One sentence, quoted in the report.
};

}  // namespace touchstone
