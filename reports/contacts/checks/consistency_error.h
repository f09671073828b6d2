#pragma once

#include <span>

#include <Eigen/Core>

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

class JudgedAnswer;

/** Returns |−separation − o(n)|: the error of an answer's depth against its own normal.
 [m] Moving B by o(n) = max_A n·x − min_B n·x along n just separates the shapes. An answer
 of depth d along n therefore claims o(n) = d, even if n is not the best direction. The
 same holds apart, where −o(n) is the gap along n. Needs no truth beyond support
 functions. Source: Ericson, Real-Time Collision Detection (2005), §4.4.1 and §5.2.1.
 @pre `n_W` is finite and not zero. */
double ConsistencyError(const ContactQuery& query, const Eigen::Vector3d& n_W,
                        double separation);

/** The same for a known OverlapAlong() the normal. */
double ConsistencyError(const Enclosure& overlap, double separation);

/** Returns |separation − s| for the separation s of the deepest contact, 0 without one:
 the error of an answer's depth against its own manifold. [m] Contacts shallower than the
 depth are legal, but a solver that receives only those does not learn the depth. Source:
 by definition of the separation, which is the least over the patch. */
double ManifoldInconsistency(std::span<const ContactPoint> contacts, double separation);

/** Judges the separation that the answer states against its own normal and manifold. */
void CheckConsistency(JudgedAnswer& judged);

}  // namespace touchstone
