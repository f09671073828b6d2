#pragma once

#include <Eigen/Core>

#include "reports/referee/contact_truth.h"
#include "reports/referee/minkowski_difference.h"

namespace touchstone::referee {

/** The certified separation of two cores. */
struct CoreTruth {
  Enclosure separation;    ///< Distance, or minus the depth. [m]
  Eigen::Vector3d n_AB_W;  ///< Unit direction of the lower bound.
  Eigen::Vector3d p_WCa;   ///< Nearest, or supporting, points of the cores. [m]
  Eigen::Vector3d p_WCb;   ///< [m]
};

/** Returns the truth about the cores whose difference is M. */
CoreTruth JudgeCores(const MinkowskiDifference& M);

}  // namespace touchstone::referee
