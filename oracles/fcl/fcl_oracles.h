#pragma once

#include <memory>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** Returns the oracles of the Flexible Collision Library:

 | name                      | entry point                      | runs |
 |---------------------------|----------------------------------|---------------------------|
 | fcl/collide               | fcl::collide, GST_LIBCCD         | in process | |
 fcl/collide_indep         | fcl::collide, GST_INDEP          | in process | |
 fcl/distance              | fcl::distance, GST_LIBCCD        | isolated
 (isolated_oracle.h) | | fcl/distance_indep        | fcl::distance, GST_INDEP         |
 isolated                  | | fcl/signed_distance       | fcl::distance signed,
 GST_LIBCCD | isolated                  | | fcl/signed_distance_indep | fcl::distance
 signed, GST_INDEP  | isolated                  |

 What the translation hides:
 - geometries are made for each question;
 - Contact::normal points from A to B: as it comes;
 - Contact::penetration_depth is positive when penetrating: negated. GST_INDEP's EPA gives
 it negative, and a normal in a body frame: as they come;
 - fcl::collide returns one contact without its place unless told otherwise: eight,
 placed;
 - Contact::pos is midway for the closed forms of FCL but for two spheres, where it is
 weighted by their radii: moved midway. Between a sphere and a capsule it is outside the
 sphere, and from MPR and EPA on no surface: as it comes;
 - fcl::distance gives no normal: taken from its nearest points where they are far enough
   apart to have a direction. Those of GST_INDEP, overlapping, are a contact's place given
   twice, and those of unsigned distance are not set: left out;
 - the distance is DistanceResult::min_distance, the function's own value being −1 at
 times;
 - sizes are given in full: half sizes are doubled;
 - a half-space is fcl::Halfspace with the body's z as its normal. fcl::distance accepts
 it, and GST_LIBCCD then calls a null support function: the crash is the answer;
 - fcl::Convex wants faces: worked out here (convex_facets.h).

 Source: fcl/narrowphase/contact.h, distance_request.h, distance_result.h of FCL 0.7.0,
 and measurement. */
std::vector<std::unique_ptr<Oracle>> FclOracles();

}  // namespace touchstone
