#pragma once

#include <Eigen/Core>

#include "scenarios/contact_query.h"

namespace touchstone {

/** A contact as ODE gives it, but for the direction of its normal. */
struct OdeContact {
  Eigen::Vector3d p_W;     ///< dContactGeom::pos. [m]
  Eigen::Vector3d n_AB_W;  ///< −dContactGeom::normal.
  double depth;            ///< dContactGeom::depth, ≥ 0. [m]
};

/** Returns the contact's point moved along its normal to midway through its overlap.

 Where ODE puts the point depends on the pair, and for some pairs on the branch taken
 (measured on 2000 random pairs each, ODE 0.16.2):

 | pair                                  | dContactGeom::pos                          |
 |---------------------------------------|--------------------------------------------|
 | sphere, capsule among themselves      | midway                                     |
 | anything, half-space                  | on the surface of the former               |
 | sphere, box                           | on the box; the centre, if that is inside  |
 | sphere, cylinder                      | on either surface, or on the axis          |
 | box, box                              | on the incident box; midway, edge on edge  |
 | box, capsule                          | midway, axis outside the box; else on the  |
 |                                       | incident of two boxes, one the capsule's   |
 | box, cylinder; disc on disc          | on either surface                          |
 | capsule, cylinder; other cylinders;   | somewhere in the overlap (MPR): left as is |
 | hull, all but half-space              |                                            |

 The point is moved from the place in this table, not from where it is: by a length that
 is known from the question and the depth. So a point that is off stays off by as much,
 and is found. Where the table leaves a choice, it is the one that fits both surfaces
 best. The place across the normal is never touched. */
Eigen::Vector3d MidwayPoint(const ContactQuery& query, const OdeContact& contact);

}  // namespace touchstone
