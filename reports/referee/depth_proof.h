#pragma once

#include <Eigen/Core>

#include "reports/referee/contact_truth.h"

namespace touchstone::referee {

/** Proved bounds on the depth of the origin in M. */
struct DepthProof {
  Enclosure depth;  ///< Bounds on the depth; `lo` is 0 if the origin is not proved to be
                    ///< inside. [m]
  Eigen::Vector3d
      n_AB_W;  ///< Unit direction along which a translation by `hi` separates.
};

}  // namespace touchstone::referee
