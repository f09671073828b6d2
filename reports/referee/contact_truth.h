#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace touchstone {

/** A closed interval that certainly contains a true value. */
struct Enclosure {
  double lo;
  double hi;
};

/** The proved answer to whether two shapes touch. */
enum class Touching {
  kApart,     ///< Proved by a separating plane wider than the input's own rounding.
  kTouching,  ///< Proved by a point in both shapes, deeper than the input's own rounding.
  kUndecided,  ///< Touching to within the rounding of the input: no answer can be proved
               ///< wrong.
};

/** A proof that a person can check by hand. */
struct Certificate {
  /** Unit direction of the proof, from A to B, world frame: the normal of the separating
   plane, or the direction along which the least translation separates. */
  Eigen::Vector3d n_AB_W;
  /** A point of A and a point of B. If the bodies are apart, they are nearest points:
   their distance is the upper bound, the support gap along n_AB_W the lower. If the
   bodies penetrate, they are supporting points. */
  Eigen::Vector3d p_WCa;  ///< [m]
  Eigen::Vector3d p_WCb;  ///< [m]
};

/** The contact patch: the convex polygon in which the two shapes touch once B is moved by
 -separation * n_AB_W. Every deepest contact lies in it. It is a point, a segment or a
 face; a disc is given by points of its rim. */
struct ContactPatch {
  std::vector<Eigen::Vector3d> vertices_W;  ///< Corners, world frame. [m]
  /** Fewest contacts that span the patch: 1 for a point, 2 for a segment, 3 for a
   triangle or a disc, 4 for any other face. */
  int least_contacts = 0;
};

/** The certified truth of one contact query. */
struct ContactTruth {
  Touching touching = Touching::kUndecided;
  /** Signed separation: the distance if apart, minus the depth if penetrating. [m] */
  Enclosure separation;
  /** Half-width of the band around zero inside which touching is undecided. It is the
   rounding of the input: the poses' orthonormality defect and one ulp of every
   coordinate. [m] */
  double input_rounding = 0;
  Certificate certificate;
  /** The method: "polytope", "core" (a polytope rounded by a sphere or capsule radius),
   "half_space" or "bounds". */
  std::string method;
};

}  // namespace touchstone
