#pragma once

#include <Eigen/Core>

#include "oracles/contact_answer.h"
#include "scenarios/contact_query.h"

namespace touchstone {

class JudgedAnswer;

/** Returns how far A extends beyond the point of a contact on A, along `n_AB_W`, or B
 beyond the point on B, against it, whichever is larger, as far as it is proved. [m]

 At a contact the line along the normal leaves A through the point on A, and enters B
 through the point on B. If a body extends further, the bodies overlap there by that much
 more than the contact says, or the normal at the point is not an outward one. The points
 may slide along a side that is parallel to the normal and stay on both surfaces: only
 this measure finds them.

 A body extends as far as the line stays within `e` [m] of it, since a computed side may
 be off by e. Distances below `least` [m] count as 0: a surface that faces along the
 normal stays behind the line at once. Source: convexity, since the line and a body meet
 in one segment.
 @pre `n_AB_W` is a unit vector. Both points lie within `e` of their bodies. */
double ContactSeparationError(const ContactQuery& query, const WitnessPoints& points,
                              const Eigen::Vector3d& n_AB_W, double e, double least);

/** Judges the own separation of every contact: neither may the bodies overlap there by
 more than it says, nor may it be apart. Points off their surfaces, or along a wrong
 normal, are wrong already. */
void CheckContactSeparations(JudgedAnswer& judged);

}  // namespace touchstone
