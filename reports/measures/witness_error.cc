#include "reports/measures/witness_error.h"

#include <cmath>

namespace touchstone {

WitnessError WitnessErrorOf(const WitnessPoints& witnesses, const Eigen::Vector3d& n_AB_W,
                            double separation) {
  const Eigen::Vector3d p_AB_W = witnesses.p_WCb - witnesses.p_WCa;
  const double along = p_AB_W.dot(n_AB_W);
  return {std::abs(along - separation), (p_AB_W - along * n_AB_W).norm()};
}

double WitnessLengthError(const WitnessPoints& witnesses, double separation) {
  return std::abs((witnesses.p_WCb - witnesses.p_WCa).norm() - std::abs(separation));
}

}  // namespace touchstone
