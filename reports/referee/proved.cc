#include "reports/referee/proved.h"

#include <limits>

#include "reports/referee/referee.h"
#include "reports/referee/witnesses.h"

namespace touchstone::referee {

Enclosure Proved(const ContactQuery& query, const CoreTruth& core) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double lo = 0 - Overlap(query, core.n_AB_W).hi;  // Not −0.
  const double hi = core.is_deep ? LessRadii(query, core.separation.hi)
                                 : ProvedSeparation(query, core.points);
  return lo <= hi ? Enclosure{lo, hi} : Enclosure{-kInfinity, kInfinity};
}

}  // namespace touchstone::referee
