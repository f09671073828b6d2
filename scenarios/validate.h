#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenarios/contact_query.h"

namespace touchstone {

/** One fault in the input: the quantity, what is wrong, and what was expected. */
struct Fault {
  std::string where;     ///< E.g. "A.half_extents[1]".
  std::string what;      ///< E.g. "is -0.5".
  std::string expected;  ///< E.g. "a finite length > 0".
};

/** Largest accepted | |q| − 1 | of a quaternion: a thousand times the rounding of a
 quaternion written with 16 digits, and far below any intended change of orientation. */
inline constexpr double kQuaternionSlack = 1e-12;

/** Largest accepted OrthonormalityDefect(): matrices in bug reports have the seven digits
 that single-precision engines print. The defect of a query widens its certified band. */
inline constexpr double kRotationSlack = 1e-6;

/** Returns the norm by which readers of files divide `q`: it is off 1 by more than
 kQuaternionSlack, the rounding of 16 digits, but by no more than kRotationSlack, that of
 seven. Empty for every other quaternion, which FaultsOf() a body accepts or refuses. */
std::optional<double> NormToDivideBy(const Eigen::Quaterniond& q);

/** The shortest and the longest length in a query. Their squares and cubes, and roundings
 of these, are normal doubles: products in a proof or a tolerance neither overflow nor
 underflow. [m] */
inline constexpr double kShortest = 1e-100;
inline constexpr double kLongest = 1e100;

/** Returns every fault of `body`; empty for a valid one. A valid body has finite numbers,
 positive sizes, lengths from kShortest to kLongest (coordinates may also be 0), a unit
 quaternion that matches the matrix, a proper rotation and at least one hull vertex.
 `where` is the key that a file uses, e.g. "half_extents[1]". */
std::vector<Fault> FaultsOf(const Body& body);

/** Returns every fault of `query`; empty for a valid one. A valid query has two valid
 bodies, at most one of them a half-space. Engines receive only valid queries. `where`
 starts with "A." or "B.". */
std::vector<Fault> FaultsOf(const ContactQuery& query);

}  // namespace touchstone
