#pragma once

#include <vector>

#include <Eigen/Core>

#include "scenarios/contact_query.h"

namespace touchstone::referee {

/** The part of a body that touches its supporting plane: a point, a segment or a face. */
struct SupportFeature {
  std::vector<Eigen::Vector3d>
      points_W;  ///< Points whose convex hull is the feature. [m]
  bool is_disc =
      false;  ///< Whether the points are the corners of a polygon around a disc.
  bool is_plane = false;  ///< Whether it is a half-space, which has no points and is
                          ///< unbounded sideways.
};

/** Returns the corners of `body` within `slack` [m] of its supporting plane along the
 unit vector `n_W`. */
SupportFeature FeatureAlong(const Body& body, const Eigen::Vector3d& n_W, double slack);

}  // namespace touchstone::referee
