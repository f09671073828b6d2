#pragma once

#include "oracles/oracle.h"

namespace touchstone {

/** Answers by DART's own collision detector, DARTCollisionDetector.

 What the translation hides:
 - frames with shapes are made for each question, in two collision groups;
 - Contact::normal points from the second object to the first: negated;
 - Contact::penetrationDepth is positive when penetrating: negated;
 - Contact::point is shared out between spheres by their radii, on a surface for a sphere
   and a box and for boxes, but midway edge on edge: moved along the normal to midway;
 - boxes have full sizes: doubled;
 - the answer's normal and separation are those of the deepest contact.

 Pairs of other shapes than spheres and boxes it passes over in silence; DART's other
 detector, fcl, makes polyhedra of spheres. Not thread safe: every frame is entered into
 the one world frame of the process.
 @pre The shapes are spheres or boxes. */
ContactAnswer AnswerByDart(const ContactQuery& query);

/** Adds to `info` what the detector can do, and what is set. */
void DescribeDartContacts(OracleInfo& info);

}  // namespace touchstone
