#pragma once

#include "oracles/contact_answer.h"

namespace touchstone {

class JudgedAnswer;

/** Returns the largest angle between two normals of one manifold, in [0, π]. [rad] A
 manifold has one normal; contacts with different normals push a solver in two directions.
 Computed by atan2 of |m × n| and m·n, because acos(m·n) resolves angles near zero only to
 √ε ≈ 1.5e-8. Source: Kahan, "How futile are mindless assessments of roundoff", §12
 (2006). */
double MixedNormals(const ContactAnswer& answer);

/** Returns the angle between `m` and `n`, in [0, π]. [rad] */
double AngleBetween(const Eigen::Vector3d& m, const Eigen::Vector3d& n);

/** Judges the normals of a manifold against each other. */
void CheckMixedNormals(JudgedAnswer& judged);

}  // namespace touchstone
