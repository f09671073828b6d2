#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "reports/referee/minkowski_difference.h"

namespace touchstone::referee {

/** The depth of the origin in M and the direction along which it is reached. */
struct CoreDepth {
  /** Signed overlap along the best candidate. If M has a volume and `lo` >= 0, it is the
   depth. Otherwise the origin may be outside M, and only −hi has a meaning: it is a lower
   bound on the distance. [m] */
  Enclosure depth;
  Eigen::Vector3d n_AB_W;  ///< Unit direction from A to B.
};

/** Returns true if the core is a zonotope: a point, a segment or a box. */
bool IsZonotope(const Core& core);

/** The faces of the difference M of two zonotopes.

 M = c + Σ [−h_k, h_k] g_k is itself a zonotope, with the edges of both as generators.
 Each of its faces is spanned by two of them. The cross products of all pairs therefore
 include every face normal: face normals of A, of B, and edge crosses alike. Along a face
 normal max n·x = n·c + Σ h_k |n·g_k|. If the origin is inside a full-dimensional M, the
 least of these per unit length is the depth. */
class ZonotopeFaces {
 public:
  /** Bounds the overlap along every face in double. @pre `M` is of zonotopes and outlives
   * this. */
  explicit ZonotopeFaces(const MinkowskiDifference& M);

  /** Returns true only if the plane of a face certainly separates the origin from M. */
  bool ProveOutside() const { return least_ < 0; }

  /** Returns the least overlap over the normals of the faces, in high precision. Empty if
   M is a point or a segment and has no faces. */
  template <typename Real>
  std::optional<CoreDepth> LeastOverlap() const;

 private:
  struct Generator {
    Eigen::Vector3d direction;  ///< A column of a pose's matrix, without rounding.
    /** Half lengths of parallel edges; their sum counts. [m] */
    std::vector<double> half_lengths;
    double half_length;  ///< Their sum, rounded. [m]
  };
  /** Two generators that may span a face. */
  struct Face {
    std::size_t i, j;  ///< Indices of the generators.
    double lo;         ///< Lower bound on the overlap along its normal. [m]
  };
  struct Candidate;

  void AddGenerator(const Eigen::Vector3d& direction, double half_length);
  void AddGenerators(const RoundedCore& placed);
  void SetErrors();
  /** Returns bounds on the overlap along the cross product of generators i and j, in
   double with errors that are known in advance. [m] */
  Enclosure RoughOverlap(std::size_t i, std::size_t j) const;
  /** Returns the overlap along the cross product of generators i and j. */
  template <typename Real>
  Candidate Evaluate(std::size_t i, std::size_t j) const;

  const MinkowskiDifference& M_;
  std::vector<Generator> generators_;
  Eigen::Vector3d centre_;  ///< M's, rounded. [m]
  double overlap_error_;    ///< Bound on the error of n · x along a rough n. [m]
  double normal_error_;     ///< Bound on the error of the length of a rough n. [-]
  std::vector<Face> faces_;
  double least_;  ///< Upper bound on the least overlap. [m]
};

}  // namespace touchstone::referee
