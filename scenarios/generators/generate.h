#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "scenarios/contact_query.h"

namespace touchstone {

/** Families of queries, each hard in its own way. The gap is measured along the direction
 in which the query was built. A gap > 0 is the separation, up to rounding. A gap < 0 is
 an overlap and bounds the depth. */
enum class Family {
  /** Any shapes at any poses, B at 0 to 5/3 of the distance at which a plane separates it
   from A. */
  kRandom,
  /** B rotated relative to A by 10^0 to 10^-16 rad; one third about a shared body axis.
   */
  kNearParallel,
  /** An edge of A across an edge of B. */
  kEdgeEdge,
  /** A vertex of one on a face of the other. */
  kVertexFace,
  /** Any features at a gap of ±10^-1 to ±10^-14 m, down to touching up to rounding. */
  kTouching,
  /** B's origin well inside A; in one sixth at A's own origin, in one third B is scaled
   by 0.05 to 0.3. */
  kDeep,
  /** Thicknesses 10^-1 to 10^-4 of the lengths, gaps a fraction of the thickness. */
  kSlabsAndNeedles,
  /** Sizes of 10^-3 to 10^3 m, half of them up to 10^5 m from the world's origin. */
  kExtremeScales,
  /** B rotated relative to A by one of the 24 rotations of the cube and one of 16
   perturbations from 10^-15 rad to π/4. Query i has rotation i mod 24 and perturbation
   i / 24 mod 16. In half of them A is not rotated, so that the symmetry is exact. If the
   kinds are equal, half have equal sizes. */
  kSymmetries,
  /** Any features at a gap of ±2^-52 to ±2^-40 m, from one rounding of the coordinates to
   4000 of them, on both sides. A third is touching to within rounding. */
  kGrazing,
  /** One shape 1 to 10^-6 times the size of the other, gaps a fraction of the lesser
   thickness. */
  kMixedSizes,
  /** The world's origin 10^2 to 10^7 m away, gaps a fraction of the thickness. */
  kFarFromOrigin,
  /** Hulls of 16 to 1,000 vertices, at a gap of ±1 to ±100 mm; shapes of other kinds as
   in kRandom. */
  kLargeHulls,
};

/** Returns the families in the order of the enumeration. */
std::vector<Family> AllFamilies();

/** Returns the name used on the command line and in reports: "random", "near_parallel",
 "edge_edge", "vertex_face", "touching", "deep", "slabs_and_needles", "extreme_scales",
 "symmetries", "grazing", "mixed_sizes", "far_from_origin", "large_hulls". */
std::string_view NameOf(Family family);

/** Returns the family with that name; empty if there is none. */
std::optional<Family> FamilyNamed(std::string_view name);

/** Returns query `index` of a family with A of kind `a` and B of kind `b`. The query is
 valid (scenarios/validate.h). It is a pure function of the arguments, the same bit for
 bit on every machine with IEEE doubles. @pre Not two half-spaces. */
ContactQuery Generate(Family family, ShapeKind a, ShapeKind b, std::uint64_t seed,
                      std::uint64_t index);

}  // namespace touchstone
