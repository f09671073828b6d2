#include "reports/measures/excess.h"

#include <algorithm>

#include "reports/measures/overlap_along.h"

namespace touchstone {

double Excess(const ContactQuery& query, const ContactTruth& truth,
              const Eigen::Vector3d& n_W) {
  // −separation.lo is the largest possible depth: only an overlap beyond it is proved
  // excess.
  return std::max(0.0, OverlapAlong(query, n_W).lo + truth.separation.lo);
}

}  // namespace touchstone
