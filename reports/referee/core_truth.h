#pragma once

#include <Eigen/Core>

#include "reports/referee/contact_truth.h"
#include "reports/referee/minkowski_difference.h"

namespace touchstone::referee {

/** The certified separation of two cores. */
struct CoreTruth {
  Enclosure separation;    ///< The distance, or minus the depth. [m]
  Eigen::Vector3d n_AB_W;  ///< Unit direction of the lower bound.
  Eigen::Vector3d p_WCa;   ///< Nearest or supporting point of the core of A. [m]
  Eigen::Vector3d p_WCb;   ///< Nearest or supporting point of the core of B. [m]
};

/** Returns the certified separation of the cores whose difference is M. */
CoreTruth JudgeCores(const MinkowskiDifference& M);

}  // namespace touchstone::referee
