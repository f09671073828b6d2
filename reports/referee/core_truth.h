#pragma once

#include <Eigen/Core>

#include "reports/referee/contact_truth.h"
#include "reports/referee/minkowski_difference.h"
#include "reports/referee/witnesses.h"

namespace touchstone::referee {

/** The certified separation of two cores, with what proves both bounds. */
template <typename Real>
struct CoreTruth {
  Enclosure separation;    ///< The distance, or minus the depth. [m]
  Eigen::Vector3d n_AB_W;  ///< Unit direction of the lower bound.
  /** Points of both cores. If the origin is not in M, they are nearest points and prove
   the upper bound; otherwise they are supporting points along n_AB_W. */
  Witnesses<Real> points;
  /** Whether the upper bound is proved by the depth of the origin in M: by all candidates
   of a zonotope, or by a closed surface. */
  bool is_deep = false;
};

/** Returns the certified separation of the cores whose difference is M, proved in `Real`.
 */
template <typename Real>
CoreTruth<Real> JudgeCores(const MinkowskiDifference& M);

}  // namespace touchstone::referee
