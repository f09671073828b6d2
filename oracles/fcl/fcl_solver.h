#pragma once

#include <memory>

#include "oracles/oracle.h"

namespace touchstone {

/** Which of FCL's two general convex solvers answers where it has no closed form. */
enum class FclSolver {
  kLibccd,  ///< GST_LIBCCD, the default: libccd's MPR for contacts, FCL's own GJK and EPA
            ///< on libccd's types for distances.
  kIndep,   ///< GST_INDEP: FCL's GJK and EPA on its own types.
};

/** What fcl::distance is asked for. */
enum class FclDistanceKind {
  kUnsigned,  ///< The distance of shapes apart; overlapping ones are −1 apart.
  kSigned,    ///< Overlapping shapes too: minus their depth.
};

/** Returns "fcl/collide" or "fcl/collide_indep", in process. */
std::unique_ptr<Oracle> MakeFclCollide(FclSolver solver);

/** Returns "fcl/distance", "fcl/distance_indep", "fcl/signed_distance" or
 "fcl/signed_distance_indep", in process: for many valid questions they abort, crash or
 hang. */
std::unique_ptr<Oracle> MakeFclDistance(FclSolver solver, FclDistanceKind kind);

}  // namespace touchstone
