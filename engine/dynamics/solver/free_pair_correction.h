#pragma once

#include "engine/dynamics/body/rigid_body.h"

namespace cookbook {

/** Position correction of two bodies in free flight that are deeper in each other than
 their slop. An impact stops the approach of their contact points. But bodies that turn
 about each other have an impact in every step, and sink in by up to ω² r h² in each.

 Adds displacements to `moved_A` and `moved_B` ([m] in `v`, [rad] in `w`, world frame).
 They remove `fraction` of the depth beyond the slop at each contact, in `iterations` of
 projected Gauss-Seidel. Returns whether a contact is deeper than the slop. */
bool CorrectFreePair(const RigidBody& A, const RigidBody& B, double fraction,
                     int iterations, Velocity& moved_A, Velocity& moved_B);

}  // namespace cookbook
