#pragma once

#include <Eigen/Core>

#include "scenarios/contact_query.h"

namespace touchstone {

/** A contact as FCL gives it. */
struct FclContact {
  Eigen::Vector3d p_W;     ///< Contact::pos. [m]
  Eigen::Vector3d n_AB_W;  ///< Contact::normal.
  double depth;            ///< Contact::penetration_depth. [m]
};

/** Returns the contact's point moved along its normal to midway through its overlap.

 Two spheres meet at cA + (cB − cA) rA / (rA + rB), which is behind the surface of A by
 the share rA / (rA + rB) of the depth, and not by half of it (FCL 0.7.0,
 sphere_sphere-inl.h). The point is moved by what is between the two: one that is off
 stays off by as much, and is found. The points of all other pairs are left as they are.
 */
Eigen::Vector3d MidwayPoint(const ContactQuery& query, const FclContact& contact);

}  // namespace touchstone
