#pragma once

#include "engine/dynamics/body/rigid_body.h"
#include "engine/dynamics/body/settings.h"

namespace cookbook {

/** Position correction of two bodies in free flight that are deeper in each other than
 their slop. Their impacts stop the approach of contact points, but bodies that turn about
 each other sink in by ω² r h² a step, and have an impact in every one. Adds the
 displacements
 ([m], [rad]) that remove `fraction` of the depth of each contact to `moved_A` and
 `moved_B`. Returns whether there is any. */
bool CorrectFreePair(const RigidBody& A, const RigidBody& B, double fraction,
                     int iterations, Velocity& moved_A, Velocity& moved_B);

}  // namespace cookbook
