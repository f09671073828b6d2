#pragma once

#include <Eigen/Core>

#include "reports/referee/bounded.h"
#include "scenarios/contact_query.h"

namespace touchstone::referee {

/** Returns the maximum of n_W · x over `body`, placed in the world. It refers to the
 affine image of the shape for the exact doubles of the pose; the ball of a sphere or a
 capsule is not transformed. Infinite for a half-space. [|n_W| m]

 Certificates are evaluated by this function. It shares no formula with the searches,
 which know of cores and differences only: a fault there cannot confirm itself. Only the
 filter of vertices in doubles is that of both. */
template <typename Real>
Bounded<Real> SupportOf(const Body& body, const Eigen::Vector3d& n_W);

}  // namespace touchstone::referee
