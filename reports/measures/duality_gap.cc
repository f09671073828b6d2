#include "reports/measures/duality_gap.h"

#include "reports/measures/outside.h"
#include "reports/measures/overlap_along.h"

namespace touchstone {

double DualityGap(const ContactQuery& query, const WitnessPoints& witnesses) {
  const Eigen::Vector3d p_AB_W = witnesses.p_WCb - witnesses.p_WCa;
  return Outside(-p_AB_W.norm(), OverlapAlong(query, p_AB_W));
}

}  // namespace touchstone
