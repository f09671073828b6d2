#pragma once

#include <string>

namespace touchstone {

/** Two numbers as text that shows how they differ. */
struct ToldApart {
  std::string a;
  std::string b;
  std::string difference;  ///< |a − b|, to three digits.
};

/** Writes `a` and `b` with `digits` significant digits, or with as many more as show two
 digits of their difference: numbers that differ never look equal. */
ToldApart TellApart(double a, double b, int digits);

}  // namespace touchstone
