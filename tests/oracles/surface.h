#pragma once

#include <Eigen/Core>

#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns the height of `p_W` above the surface of `body`: 0 on it, < 0 inside, > 0
 outside. Near a smooth part of the surface it is the signed distance. [m]
 @pre A hull has volume. */
double HeightAboveSurface(const Body& body, const Eigen::Vector3d& p_W);

}  // namespace touchstone
