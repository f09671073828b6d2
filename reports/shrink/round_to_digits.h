#pragma once

namespace touchstone {

/** The number of significant digits that every double keeps as a decimal
 (std::numeric_limits<double>::digits10). */
inline constexpr int kSurelyKeptDigits = 15;

/** Returns the double nearest to `x` rounded to `digits` significant decimal digits. */
double RoundToDigits(double x, int digits);

}  // namespace touchstone
