#pragma once

#include <string>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** The violations of the contract by an oracle, one sentence each. */
using Breaches = std::vector<std::string>;

/* The clauses of oracles/oracle.h and oracles/contact_answer.h. Each clause queries
 shapes of kinds `a` and `b` that are 2 mm deep in each other or 2 mm apart, with faces
 and flanks a hundred times as wide. There is one right answer, and no engine documents
 another.

 The tolerance is the rounding of the engine (reports/contacts/tolerances.h) plus the
 error that it documents. A normal may tilt as far as that error can tilt it. */

/** Touching, separation and normal are those of the construction, in either order of the
 bodies. Contacts lie between the surfaces, witnesses on them. All fields that the
 capabilities promise are present. */
Breaches KnownAnswer(const Oracle& oracle, ShapeKind a, ShapeKind b);

/** Swapping the bodies negates the normal and changes nothing else. */
Breaches Swap(const Oracle& oracle, ShapeKind a, ShapeKind b);

/** B no longer touches A after a move along the normal by the depth plus a clearance, and
 still touches it after a move by the depth minus a clearance. Applies to oracles that
 return depth and normal. */
Breaches PushApart(const Oracle& oracle, ShapeKind a, ShapeKind b);

/** A rigid motion of both bodies rotates the normal with them and keeps the separation.
 */
Breaches RigidMotion(const Oracle& oracle, ShapeKind a, ShapeKind b);

/** Every supported question has the same answer, bit for bit, when the questions are
 asked one by one, again in the opposite order, as a batch, and by two threads at once. */
Breaches Pure(const Oracle& oracle);

}  // namespace touchstone
