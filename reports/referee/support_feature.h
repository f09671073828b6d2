#pragma once

#include <vector>

#include <Eigen/Core>

#include "scenarios/contact_query.h"

namespace touchstone::referee {

/** The part of a body that touches its supporting plane: a point, a segment or a face. */
struct SupportFeature {
  std::vector<Eigen::Vector3d> points_W;  ///< Their hull is the feature. [m]
  bool is_disc = false;   ///< The points are the corners of a polygon around a disc.
  bool is_plane = false;  ///< A half-space: no points, it bounds nothing sideways.
};

/** Returns the corners of `body` within `slack` [m] of its supporting plane along the
 unit vector `n_W`. */
SupportFeature FeatureAlong(const Body& body, const Eigen::Vector3d& n_W, double slack);

}  // namespace touchstone::referee
