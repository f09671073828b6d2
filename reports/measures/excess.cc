#include "reports/measures/excess.h"

#include <algorithm>

#include "reports/measures/overlap_along.h"

namespace touchstone {

double Excess(const ContactQuery& query, const ContactTruth& truth,
              const Eigen::Vector3d& n_W) {
  return Excess(OverlapAlong(query, n_W), truth);
}

double Excess(const Enclosure& overlap, const ContactTruth& truth) {
  // −separation.lo is the largest possible depth: only an overlap beyond it is proved
  // excess.
  return std::max(0.0, overlap.lo + truth.separation.lo);
}

}  // namespace touchstone
