#pragma once

#include <Eigen/Core>

#include "scenarios/contact_query.h"

namespace touchstone {

/** A contact as ODE returns it, except that the normal is negated. */
struct OdeContact {
  Eigen::Vector3d p_W;     ///< dContactGeom::pos. [m]
  Eigen::Vector3d n_AB_W;  ///< −dContactGeom::normal.
  double depth;            ///< dContactGeom::depth, ≥ 0. [m]
};

/** Returns the point of `contact`, moved along its normal to midway through its overlap.

 ODE's position depends on the pair, and for some pairs on the branch of its code
 (measured on 2000 random pairs each, ODE 0.16.2):

 | pair                                  | dContactGeom::pos                           |
 |---------------------------------------|---------------------------------------------|
 | spheres and capsules                  | midway                                      |
 | any shape, half-space                 | on the surface of that shape                |
 | sphere, box                           | on the box; the sphere's centre if inside   |
 | sphere, cylinder                      | on either surface, or on the axis           |
 | box, box                              | midway if edge on edge, else on the         |
 |                                       | incident box                                |
 | box, capsule                          | midway if the axis is outside the box, else |
 |                                       | on the incident one of two boxes, with the  |
 |                                       | capsule taken as a box                      |
 | box, cylinder; disc on disc           | on either surface                           |
 | capsule, cylinder; other cylinders;   | somewhere in the overlap (MPR); unchanged   |
 | hull, anything except half-space      |                                             |

 The point is moved by the distance from the place in this table to midway, which follows
 from the question and the depth. So a point that is off its place stays off by the same
 amount and is found. If the table leaves a choice, the place that fits both surfaces best
 is used. The position across the normal never changes. */
Eigen::Vector3d MidwayPoint(const ContactQuery& query, const OdeContact& contact);

}  // namespace touchstone
