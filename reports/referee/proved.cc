#include "reports/referee/proved.h"

#include <limits>

#include "reports/referee/overlap_in.h"
#include "reports/referee/witnesses.h"

namespace touchstone::referee {

template <typename Real>
Enclosure Proved(const ContactQuery& query, const CoreTruth<Real>& core) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double lo = 0 - OverlapIn<Real>(query, core.n_AB_W).hi;  // Not −0.
  const double hi = core.is_deep ? LessRadii<Real>(query, core.separation.hi)
                                 : ProvedSeparation(query, core.points);
  return lo <= hi ? Enclosure{lo, hi} : Enclosure{-kInfinity, kInfinity};
}

template Enclosure Proved(const ContactQuery&, const CoreTruth<DoubleDouble>&);
template Enclosure Proved(const ContactQuery&, const CoreTruth<Precise>&);

}  // namespace touchstone::referee
