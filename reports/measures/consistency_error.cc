#include "reports/measures/consistency_error.h"

#include <algorithm>
#include <cmath>

#include "reports/measures/outside.h"
#include "reports/measures/overlap_along.h"

namespace touchstone {

double ConsistencyError(const ContactQuery& query, const Eigen::Vector3d& n_W,
                        double separation) {
  return ConsistencyError(OverlapAlong(query, n_W), separation);
}

double ConsistencyError(const Enclosure& overlap, double separation) {
  return Outside(-separation, overlap);
}

double ManifoldInconsistency(std::span<const ContactPoint> contacts, double separation) {
  if (contacts.empty()) return 0;
  double deepest = contacts.front().separation;
  for (const ContactPoint& contact : contacts)
    deepest = std::min(deepest, contact.separation);
  return std::abs(deepest - separation);
}

}  // namespace touchstone
