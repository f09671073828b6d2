#include "reports/measures/consistency_error.h"

#include "reports/measures/outside.h"
#include "reports/measures/overlap_along.h"

namespace touchstone {

double ConsistencyError(const ContactQuery& query, const Eigen::Vector3d& n_W,
                        double separation) {
  return Outside(-separation, OverlapAlong(query, n_W));
}

}  // namespace touchstone
