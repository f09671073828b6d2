#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "scenarios/contact_query.h"

namespace touchstone {

/** Families of questions, each hard in its own way. "Gap" is along the direction that the
 question was built with: for a gap > 0 it is the separation, to rounding; a gap < 0 is an
 overlap, and the depth is at most that. */
enum class Family {
  /** Any shapes at any poses, B at 0 to 5/3 of the distance where a plane parts it from
     A. */
  kRandom,
  /** B turned against A by 10^0 to 10^-16 rad; one third about a shared body axis. */
  kNearParallel,
  /** An edge of A across an edge of B. */
  kEdgeEdge,
  /** A vertex of one on a face of the other. */
  kVertexFace,
  /** Any features at a gap of ±10^-1 to ±10^-14 m: touching to a rounding. */
  kTouching,
  /** B's origin well inside A, one sixth of them at A's own origin, one third wholly
     inside. */
  kDeep,
  /** Thicknesses 10^-1 to 10^-4 of the lengths, gaps a share of the thickness. */
  kSlabsAndNeedles,
  /** Sizes of 10^-3 to 10^3 m, half of them up to 10^5 m away from the world's origin. */
  kExtremeScales,
  /** B turned against A by one of the 24 rotations of the cube and one of 16
   perturbations from 10^-15 rad to π/4: question i has rotation i mod 24 and perturbation
   i / 24 mod 16. Half of them with A unturned, so that the symmetry is exact; half with
   equal sizes where the kinds are equal. */
  kSymmetries,
};

/** Returns the families in the order above. */
std::vector<Family> AllFamilies();

/** Returns the name used on the command line and in reports: "random", "near_parallel",
 "edge_edge", "vertex_face", "touching", "deep", "slabs_and_needles", "extreme_scales",
 "symmetries". */
std::string_view NameOf(Family family);

/** Returns the family of that name; empty where there is none. */
std::optional<Family> FamilyNamed(std::string_view name);

/** Returns question `index` of a family with A of kind `a` and B of kind `b`: a pure
 function of its arguments, the same bit for bit on every machine with IEEE doubles.
 @pre Not two half-spaces. The query is valid (scenarios/validate.h). */
ContactQuery Generate(Family family, ShapeKind a, ShapeKind b, std::uint64_t seed,
                      std::uint64_t index);

}  // namespace touchstone
