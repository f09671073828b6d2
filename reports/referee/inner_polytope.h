#pragma once

#include <array>
#include <vector>

#include "reports/referee/depth_proof.h"
#include "reports/referee/nearest_point.h"

namespace touchstone::referee {

/** A triangle of an inner polytope, seen counterclockwise from outside. */
template <typename Real>
struct Facet {
  std::array<int, 3> corners;  ///< Indices into InnerPolytope::vertices.
  std::array<int, 3>
      neighbours;  ///< Facets across the side from corner i to corner i + 1.
  Vector<Real> n;  ///< Unit outward normal, to rounding.
  Real distance;   ///< Distance of its plane from the origin, along n. [m]
  bool removed = false;
};

/** A polytope of points of M around the origin, and the direction of the least overlap
 found while growing it. It is a guess: CertifyDepth() proves bounds from it. */
template <typename Real>
struct InnerPolytope {
  std::vector<DifferencePoint<Real>> vertices;
  std::vector<Facet<Real>>
      facets;      ///< All facets, including removed ones; empty if M is flat.
  Vector<Real> n;  ///< Unit direction of the least overlap found.
  Real overlap;    ///< The overlap along n, to rounding. [m]
};

/** Grows an inner polytope by the expanding polytope algorithm (EPA). It starts from a
 simplex that contains the origin. It ends when its nearest facet is within `target` [m]
 of the boundary of M, or when it has `most_vertices`. */
template <typename Real>
InnerPolytope<Real> Expand(const MinkowskiDifference& M, const Simplex<Real>& simplex,
                           double target, std::size_t most_vertices);

/** Proves bounds on the depth of the origin in M. The upper bound is the overlap along
 any direction.

 The lower bound is the radius ρ of a ball about the origin. The ball lies in M if the
 surface of triangles is closed, each triangle x_1 x_2 x_3 of points of M has det(x_1,
 x_2, x_3) > 0, and each has a direction n with n·x_i >= ρ |n|. Proof: project the surface
 radially onto the unit sphere. A closed oriented surface whose triangles all keep their
 orientation covers the sphere with a degree that counts sheets, all of one sign. The
 degree is not zero, so every direction u meets a triangle. There t u is a convex
 combination of the x_i for some t > 0, so that it lies in M, and t >= n·(t u) / |n| >= ρ.
 The same holds for −u. M is convex, so it contains the origin and the whole segment from
 the origin to t u.

 The proof does not assume that the surface is convex, so the rounding of the search does
 not matter. */
template <typename Real, typename Search>
DepthProof CertifyDepth(const MinkowskiDifference& M,
                        const InnerPolytope<Search>& polytope, double target);

}  // namespace touchstone::referee
