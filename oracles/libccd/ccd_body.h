#pragma once

#include <Eigen/Core>

#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns the support point of `body` along `direction_W`, which need not be a unit
 vector. If several points are equally far, the result for boxes, cylinders and cones is
 their middle, as in libccd's own support functions. World frame. [m]
 @pre The body is not a half-space. */
Eigen::Vector3d CcdSupport(const Body& body, const Eigen::Vector3d& direction_W);

/** Returns a point inside `body`. World frame. [m] */
Eigen::Vector3d CcdCentre(const Body& body);

}  // namespace touchstone
