#pragma once

#include <array>
#include <vector>

#include "reports/referee/depth_proof.h"
#include "reports/referee/nearest_point.h"

namespace touchstone::referee {

/** A triangle of an inner polytope, seen counterclockwise from outside. */
template <typename Real>
struct Facet {
  std::array<int, 3> corners;     ///< Indices of vertices.
  std::array<int, 3> neighbours;  ///< Across the side from corner i to corner i + 1.
  Vector<Real> n;                 ///< Unit outward normal, to rounding.
  Real distance;                  ///< Of its plane from the origin, along n. [m]
  bool removed = false;
};

/** A polytope of points of M around the origin, and the shallowest direction met while
 growing it. A guess: CertifyDepth() proves what it is worth. */
template <typename Real>
struct InnerPolytope {
  std::vector<DifferencePoint<Real>> vertices;
  std::vector<Facet<Real>> facets;  ///< Removed ones included. None where M is flat.
  Vector<Real> n;                   ///< Unit direction of the least overlap met.
  Real overlap;                     ///< The overlap along n, to rounding. [m]
};

/** Grows a polytope from a simplex that holds the origin until its nearest facet is on
 the boundary of M to within `target` [m], or until it has `most_vertices`: the expanding
 polytope algorithm. */
template <typename Real>
InnerPolytope<Real> Expand(const MinkowskiDifference& M, const Simplex<Real>& simplex,
                           double target, std::size_t most_vertices);

/** Proves bounds on the depth of the origin in M.

 Upper: the overlap along any direction.

 Lower: the ball of radius ρ lies in M if the surface of triangles is closed, each
 triangle x_1 x_2 x_3 of points of M has det(x_1, x_2, x_3) > 0, and each has a direction
 n with n·x_i >= ρ |n|. For, projected radially onto the unit sphere, a closed oriented
 surface whose triangles all keep their orientation covers the sphere with a degree that
 counts sheets, all of one sign: it is not zero, so every direction u meets a triangle.
 There t u is a mixture of the x_i for some t > 0, so that it lies in M, and t >= n·(t u)
 / |n| >= ρ. The same holds of −u, so that M, being convex, holds the origin and all of
 the segment from the origin to t u. No convexity of the surface is used, so it does not
 matter how the search rounded. */
template <typename Real>
DepthProof CertifyDepth(const MinkowskiDifference& M, const InnerPolytope<Real>& polytope,
                        double target);

}  // namespace touchstone::referee
