#pragma once

#include <Eigen/Core>

#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns 0 where `p_W` is on the surface of `body`, < 0 inside, > 0 outside; near a
 smooth part of the surface it is the signed distance. [m] The hull of a test has volume.
 */
double HeightAboveSurface(const Body& body, const Eigen::Vector3d& p_W);

}  // namespace touchstone
