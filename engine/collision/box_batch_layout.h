#pragma once

#include <cstddef>

namespace cookbook {

/** Number of pairs in a block: the lanes of the widest vector of doubles in use. */
inline constexpr std::size_t kLanes = 8;

/** Rows of a block. First for A, then for B: the rotation column by column, the position,
 the half extents. */
inline constexpr std::size_t kRotationRow = 0;
inline constexpr std::size_t kPlaceRow = 9;
inline constexpr std::size_t kHalfExtentsRow = 12;
inline constexpr std::size_t kRowsOfB = 15;
inline constexpr std::size_t kRows = 30;

/** The results of the search: an AxisGap per pair, in arrays padded to whole blocks. */
struct GapArrays {
  double* axis;        ///< 0…2 faces of A, 3…5 of B, 6 + 3 i + j edges.
  double* separation;  ///< [m]
  double* sine;        ///< |a_i × b_j|; 1 for a face.
  double* offset;      ///< [m]
};

/** Finds the gaps of `blocks` blocks with the widest vectors of this processor. */
void FindBlockGaps(const double* rows, std::size_t blocks, const GapArrays& gaps);

}  // namespace cookbook
