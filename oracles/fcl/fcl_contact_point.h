#pragma once

#include <Eigen/Core>

#include "scenarios/contact_query.h"

namespace touchstone {

/** A contact as FCL returns it. */
struct FclContact {
  Eigen::Vector3d p_W;     ///< Contact::pos. [m]
  Eigen::Vector3d n_AB_W;  ///< Contact::normal.
  double depth;            ///< Contact::penetration_depth. [m]
};

/** Returns the point of `contact`, moved along its normal to midway through its overlap.

 For two spheres FCL returns cA + (cB − cA) rA / (rA + rB). This is inside the surface of
 A by the fraction rA / (rA + rB) of the depth instead of half of it (FCL 0.7.0,
 sphere_sphere-inl.h). The point is moved by the difference of the two: a point that is
 off stays off by the same amount and is found. The points of all other pairs are returned
 unchanged. */
Eigen::Vector3d MidwayPoint(const ContactQuery& query, const FclContact& contact);

}  // namespace touchstone
