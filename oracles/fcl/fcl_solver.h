#pragma once

#include <memory>

#include "oracles/oracle.h"

namespace touchstone {

/** The general convex solver that FCL uses where it has no closed form. */
enum class FclSolver {
  kLibccd,  ///< GST_LIBCCD, the default: libccd's MPR for contacts, FCL's own GJK and EPA
            ///< on libccd's types for distances.
  kIndep,   ///< GST_INDEP: FCL's GJK and EPA on its own types.
};

/** The kind of distance that fcl::distance computes. */
enum class FclDistanceKind {
  kUnsigned,  ///< Distance of shapes that are apart; −1 for overlapping shapes.
  kSigned,    ///< Also the depth of overlapping shapes, negated.
};

/** Returns "fcl/collide" or "fcl/collide_indep", in process. */
std::unique_ptr<Oracle> MakeFclCollide(FclSolver solver);

/** Returns "fcl/distance", "fcl/distance_indep", "fcl/signed_distance" or
 "fcl/signed_distance_indep", in process. They abort, crash or hang on many valid
 questions, so they need Isolate(). */
std::unique_ptr<Oracle> MakeFclDistance(FclSolver solver, FclDistanceKind kind);

}  // namespace touchstone
