#pragma once

#include <memory>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** Returns the oracles of the Flexible Collision Library:

 | name                      | entry point                      | runs       |
 |---------------------------|----------------------------------|------------|
 | fcl/collide               | fcl::collide, GST_LIBCCD         | in process |
 | fcl/collide_indep         | fcl::collide, GST_INDEP          | in process |
 | fcl/distance              | fcl::distance, GST_LIBCCD        | isolated   |
 | fcl/distance_indep        | fcl::distance, GST_INDEP         | isolated   |
 | fcl/signed_distance       | fcl::distance signed, GST_LIBCCD | isolated   |
 | fcl/signed_distance_indep | fcl::distance signed, GST_INDEP  | isolated   |

 See isolated_oracle.h for "isolated". The translation does the following:
 - geometries are created for each question;
 - Contact::normal points from A to B: unchanged;
 - Contact::penetration_depth is positive when penetrating: negated. GST_INDEP's EPA
   returns it negative, with a normal in a body frame: both are passed on;
 - fcl::collide returns one contact without a position by default: eight with positions
   are requested;
 - Contact::pos is midway for FCL's closed forms, except for two spheres, where it is
   weighted by their radii and is moved to midway. Between a sphere and a capsule it is
   outside the sphere, and from MPR and EPA it is on no surface: unchanged;
 - fcl::distance returns no normal: it is computed from the nearest points if these are
   far enough apart to define a direction. On overlap, the nearest points of GST_INDEP
   are one contact position twice, and those of the unsigned distance are not set: left
   out;
 - the distance is DistanceResult::min_distance, because the return value of fcl::distance
   is sometimes −1;
 - FCL takes full sizes: half sizes are doubled;
 - a half-space is fcl::Halfspace with the body's z as its normal. fcl::distance accepts
   it, but GST_LIBCCD then calls a null support function: the answer is the crash;
 - fcl::Convex requires faces: they are computed here (convex_facets.h).

 Source: fcl/narrowphase/contact.h, distance_request.h, distance_result.h of FCL 0.7.0,
 and measurement. */
std::vector<std::unique_ptr<Oracle>> FclOracles();

}  // namespace touchstone
