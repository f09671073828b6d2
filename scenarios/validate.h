#pragma once

#include <string>
#include <vector>

#include "scenarios/contact_query.h"

namespace touchstone {

/** One fault of a query: which quantity, and what was expected instead. */
struct Fault {
  std::string where;     ///< E.g. "A.half_extents[1]".
  std::string what;      ///< E.g. "is -0.5".
  std::string expected;  ///< E.g. "a finite length > 0".
};

/** Largest accepted | |q| − 1 | of a quaternion: a thousand times the rounding of one
 written with 16 digits, far below anything that means a rotation. */
inline constexpr double kQuaternionSlack = 1e-12;

/** Largest accepted OrthonormalityDefect(): matrices of bug reports come with the seven
 digits that float engines print. The defect of a query widens its certified band. */
inline constexpr double kRotationSlack = 1e-6;

/** The shortest and the longest length of a question. The square and the cube of either,
 and a rounding of them, are doubles with all their digits: what a proof or a tolerance
 multiplies neither overflows nor vanishes. [m] */
inline constexpr double kShortest = 1e-100;
inline constexpr double kLongest = 1e100;

/** Returns every fault of `body`; empty for a valid one. Finite numbers, positive sizes,
 lengths from kShortest to kLongest or, of coordinates, 0; unit quaternion that gives the
 matrix, proper rotation, at least one hull vertex. `where` is the key that a file uses,
 e.g. "half_extents[1]". */
std::vector<Fault> FaultsOf(const Body& body);

/** Returns every fault of `query`; empty for a valid one. Checked before any engine sees
 it: both bodies valid, not two half-spaces. `where` starts with "A." or "B.". */
std::vector<Fault> FaultsOf(const ContactQuery& query);

}  // namespace touchstone
