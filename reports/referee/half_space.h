#pragma once

#include "reports/referee/bounded.h"
#include "scenarios/contact_query.h"

namespace touchstone::referee {

/** Returns true if either body is a half-space. */
bool HasHalfSpace(const ContactQuery& query);

/** The overlap of a half-space and a bounded body along the plane's normal. */
struct PlaneOverlap {
  Enclosure overlap;         ///< Negative if apart. [m]
  Eigen::Vector3d n_AB_W;    ///< Unit normal of the plane, from A to B.
  Eigen::Vector3d p_WX;      ///< Deepest point of the bounded body in the half-space. [m]
  Eigen::Vector3d p_WPlane;  ///< Projection of p_WX onto the plane. [m]
};

/** Returns the overlap along the normal of the plane's affine image, which is
 perpendicular to R_x and R_y. This overlap is the depth: no other direction separates a
 half-space, or reaches it, by a shorter translation.
 @pre HasHalfSpace(query). */
template <typename Real>
PlaneOverlap OverlapWithPlane(const ContactQuery& query);

}  // namespace touchstone::referee
