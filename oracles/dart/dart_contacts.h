#pragma once

#include "oracles/oracle.h"

namespace touchstone {

/** Answers `query` with DART's own collision detector, DARTCollisionDetector.

 The translation does the following:
 - frames with shapes are created for each question, in two collision groups;
 - Contact::normal points from the second object to the first: negated;
 - Contact::penetrationDepth is positive when penetrating: negated;
 - Contact::point is moved along the normal to midway. DART weights it by the radii for
   two spheres. It puts it on a surface for a sphere and a box and for two boxes, but
   midway where an edge meets an edge;
 - boxes have full sizes: half sizes are doubled;
 - the answer's normal and separation are those of the deepest contact.

 The detector silently ignores pairs of shapes other than spheres and boxes; DART's other
 detector, fcl, makes polyhedra of spheres. Not thread safe: every frame is registered in
 the single world frame of the process.
 @pre The shapes are spheres or boxes. */
ContactAnswer AnswerByDart(const ContactQuery& query);

/** Adds the capabilities of the detector and its settings to `info`. */
void DescribeDartContacts(OracleInfo& info);

}  // namespace touchstone
