#pragma once

#include <Eigen/Core>

#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns the farthest point of `body` along `direction_W`, which need not be a unit
 vector; where several are as far, the middle of them for boxes, cylinders and cones, as
 libccd's own support functions have it. World frame. [m] The body is not a half-space. */
Eigen::Vector3d CcdSupport(const Body& body, const Eigen::Vector3d& direction_W);

/** Returns a point inside `body`. World frame. [m] */
Eigen::Vector3d CcdCentre(const Body& body);

}  // namespace touchstone
