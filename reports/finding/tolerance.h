#pragma once

#include <cmath>
#include <limits>
#include <string>

namespace touchstone {

/** An acceptable error, and the argument for it. */
struct Tolerance {
  double value = 0;
  std::string because;  ///< One sentence, quoted in the report.
};

/** Returns a value as a multiple of its tolerance: 0 for 0, infinite if either is NaN,
 and for a positive value with a tolerance of zero. [-] */
inline double InTolerances(double value, double tolerance) {
  if (std::isnan(value) || std::isnan(tolerance))
    return std::numeric_limits<double>::infinity();
  return value == 0 ? 0 : value / tolerance;
}

}  // namespace touchstone
