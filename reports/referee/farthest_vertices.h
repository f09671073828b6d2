#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include <Eigen/Core>

#include "reports/referee/precise.h"

namespace touchstone::referee {

/** Calls `visit` with each vertex that may be the farthest along n. Doubles leave out the
 others, usually all but one, so that only a few need more digits.
 @param n Direction of any length.
 @param error How much each coordinate of n may be off. */
template <typename Visit>
void ForEachFarthest(std::span<const Eigen::Vector3d> vertices, const Eigen::Vector3d& n,
                     const Eigen::Vector3d& error, Visit visit) {
  // The dot product is off by four roundings of each term, its bound by some more. What
  // underflows has no relative rounding.
  constexpr double kRoundings = 16 * kRoundoff<double>;
  constexpr double kLost = 8 * kUnderflow<double>;
  const Eigen::Vector3d most = (error + kRoundings * n.cwiseAbs()).array() + kLost;
  double least = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& v : vertices)
    least = std::max(least, n.dot(v) - most.dot(v.cwiseAbs()) - kLost);
  for (const Eigen::Vector3d& v : vertices) {
    // Written so that no NaN leaves out a vertex.
    if (!(n.dot(v) + most.dot(v.cwiseAbs()) + kLost < least)) visit(v);
  }
}

}  // namespace touchstone::referee
