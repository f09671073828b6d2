#pragma once

#include <cstddef>

namespace cookbook {

/** Pairs in a block: the widest vector of doubles in use. */
inline constexpr std::size_t kLanes = 8;

/** Rows of a block: for A, then B, the rotation column by column, the place, the half
 * extents. */
inline constexpr std::size_t kRotationRow = 0;
inline constexpr std::size_t kPlaceRow = 9;
inline constexpr std::size_t kHalfExtentsRow = 12;
inline constexpr std::size_t kRowsOfB = 15;
inline constexpr std::size_t kRows = 30;

/** What the search finds: AxisGap, pair after pair, in arrays of whole blocks. */
struct GapArrays {
  double* axis;        ///< 0…2 faces of A, 3…5 of B, 6 + 3 i + j edges.
  double* separation;  ///< [m]
  double* sine;
  double* offset;  ///< [m]
};

/** Finds the gaps of `blocks` blocks, with the vectors of this processor. */
void FindBlockGaps(const double* rows, std::size_t blocks, const GapArrays& gaps);

}  // namespace cookbook
