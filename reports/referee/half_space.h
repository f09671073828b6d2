#pragma once

#include "reports/referee/bounded.h"
#include "scenarios/contact_query.h"

namespace touchstone::referee {

/** Returns true where either body is a half-space. */
bool HasHalfSpace(const ContactQuery& query);

/** The overlap of a half-space and a bounded body along the plane's normal. */
struct PlaneOverlap {
  Enclosure overlap;         ///< Negative where apart. [m]
  Eigen::Vector3d n_AB_W;    ///< Unit normal of the plane, from A to B.
  Eigen::Vector3d p_WX;      ///< Point of the bounded body deepest in the half-space. [m]
  Eigen::Vector3d p_WPlane;  ///< Its foot on the plane. [m]
};

/** Returns the overlap along the normal of the plane's affine image, which is
 perpendicular to R_x and R_y. It is the depth: no other direction ever separates a
 half-space, or gets closer.
 @pre HasHalfSpace(query). */
PlaneOverlap OverlapWithPlane(const ContactQuery& query);

}  // namespace touchstone::referee
