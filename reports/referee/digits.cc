#include "reports/referee/digits.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/referee/zonotope.h"

namespace touchstone::referee {

namespace {

/** The width that is nothing to a separation, as a fraction of it. [-] */
constexpr double kShare = 0x1p-40;

}  // namespace

bool IsTight(const Enclosure& length) {
  return std::nextafter(length.lo, std::numeric_limits<double>::infinity()) >= length.hi;
}

bool IsFinal(const Enclosure& searched, const Enclosure& proved,
             const MinkowskiDifference& M) {
  if (IsTight(proved)) return true;
  const double least = std::max(proved.lo, -proved.hi);
  const double width = proved.hi - proved.lo;
  const double rounding = std::numeric_limits<double>::epsilon() * M.Size();
  // Without a sign `least` is not positive.
  if (!(least > 0) || width > 32 * rounding) return false;
  // A search on round or many faces may find a better direction with more digits.
  const bool is_exact = IsZonotope(M.A().core) && IsZonotope(M.B().core);
  const double known = is_exact ? searched.hi - searched.lo : width;
  return IsTight(searched) || known <= kShare * least;
}

}  // namespace touchstone::referee
