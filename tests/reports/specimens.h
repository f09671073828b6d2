#pragma once

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** A question with its truth and its right answer, both derived by hand. */
struct Specimen {
  ContactQuery query;
  ContactTruth truth;
  ContactAnswer right;
};

/** Returns a pose aligned with no axis and exact in no digit, so that no rounding is
 avoided by luck. */
Pose AwkwardPose();

/** Returns `pose` moved by `p_B` and turned by `R`, both in its own frame. */
Pose Placed(const Pose& pose, const Eigen::Vector3d& p_B,
            const Eigen::Matrix3d& R = Eigen::Matrix3d::Identity());

//          ___
//        .'   '.   B, radius r = 1/3, centre at (0.07, -0.03, h + r - d) in A's frame
//   ____(___d___)____  z = h = 0.1
//  |                 |
//  |        A        |   The overlap is d deep along z: n = +z, separation = -d, contact
//  |_________________|   at (0.07, -0.03, h - d/2). If d < 0, a gap of -d.
//
/** Returns a sphere that penetrates a box face of half extents (0.3, 0.2, 0.1) by
 `depth`. [m] */
Specimen SphereInBoxFace(double depth);

//      ______
//     |  B   |      B is yawed by 0.4 about z, half extents (0.06, 0.05, 0.11).
//   __|______|___ z = h    Its whole lower face is inside A's upper face and d below it:
//  |             |         n = +z, separation = -d, contacts at B's four lower corners,
//  |             |         at z = h - d/2.
//  |_____A_______|
//
/** Returns a box that penetrates the face of another by `depth`. [m] */
Specimen BoxOnBoxFace(double depth);

/** Returns B's lower face in BoxOnBoxFace(): its contacts, in order around it. */
ContactPatch LowerFaceOf(const Specimen& box_on_box);

/** Returns a sphere that penetrates a half-space by `depth`. [m] */
Specimen SphereInHalfSpace(double depth);

}  // namespace touchstone
