#pragma once

#include <string>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** What an oracle did against its contract, a sentence each. Empty: it kept it. */
using Breaches = std::vector<std::string>;

/* The clauses of oracles/oracle.h and oracles/contact_answer.h. Each asks about shapes of
 kinds `a` and `b`, 2 mm deep in each other or 2 mm apart with faces and flanks a hundred
 times as wide, where there is one right answer and no engine documents another.

 Allowed is the rounding of the engine (reports/contacts/tolerances.h) and the error it documents; a
 normal may tilt as far as that error can tilt it. */

/** Touching, separation and normal are those of the construction, in either order of the
 bodies; contacts lie between the surfaces, witnesses on them; and what the capabilities
 promise is there. */
Breaches KnownAnswer(const Oracle& oracle, ShapeKind a, ShapeKind b);

/** Swapping the bodies negates the normal and changes nothing else. */
Breaches Swap(const Oracle& oracle, ShapeKind a, ShapeKind b);

/** B moved out along the normal by its depth and a clearance touches no more; moved a
 clearance less than its depth it still does. For oracles that give depth and normal. */
Breaches PushApart(const Oracle& oracle, ShapeKind a, ShapeKind b);

/** A rigid motion of both bodies turns the normal with them and leaves the separation. */
Breaches RigidMotion(const Oracle& oracle, ShapeKind a, ShapeKind b);

/** Asked one by one, asked again in the opposite order, asked as a batch and asked by two
 threads at once, every supported question gets bit for bit the same answer. */
Breaches Pure(const Oracle& oracle);

}  // namespace touchstone
