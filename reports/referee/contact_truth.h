#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace touchstone {

/** A closed interval that certainly holds a true value. */
struct Enclosure {
  double lo;
  double hi;
};

/** Whether two shapes touch, as far as it can be proved. */
enum class Touching {
  kApart,     ///< Proved by a separating plane wider than the input's own rounding.
  kTouching,  ///< Proved by a point in both shapes, deeper than the input's own rounding.
  kUndecided,  ///< Touching to within the rounding of the input: nobody can be wrong.
};

/** A proof that anyone can check by hand, in words and numbers. */
struct Certificate {
  /** The unit direction of the proof: the plane that separates, or the direction along
   which the least translation separates. From A to B, world frame. */
  Eigen::Vector3d n_AB_W;
  /** A point of A and a point of B: nearest points where apart (their distance is the
   upper bound, the support gap along n_AB_W the lower), supporting points where
   penetrating. */
  Eigen::Vector3d p_WCa;  ///< [m]
  Eigen::Vector3d p_WCb;  ///< [m]
};

/** Where the two shapes touch once B is moved by -separation * n_AB_W: the convex polygon
 (a point, a segment, or a face; discs are given by points of their rim) in which every
 deepest contact lies. */
struct ContactPatch {
  std::vector<Eigen::Vector3d> vertices_W;  ///< Corners, world frame. [m]
  int least_contacts = 0;  ///< Fewest contacts that span it: 1 a point, 2 a segment, 3 a
                           ///< triangle or a disc, 4 any other face.
};

/** The certified truth of one contact query. */
struct ContactTruth {
  Touching touching = Touching::kUndecided;
  /** Signed separation: distance where apart, minus the depth where penetrating. [m] */
  Enclosure separation;
  /** Half-width of the band around zero inside which the touching verdict is undecided:
   rounding of the input, from the poses' orthonormality defect and one ulp of every
   coordinate. [m] */
  double input_rounding = 0;
  Certificate certificate;
  /** "polytope", "core" (sphere- or capsule-rounded polytope), "half_space", "bounds". */
  std::string method;
};

}  // namespace touchstone
