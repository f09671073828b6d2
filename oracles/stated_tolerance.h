#pragma once

#include <memory>
#include <string>

#include "oracles/oracle.h"

namespace touchstone {

/** The unit roundoff of the arithmetic in which a routine computes: float and double. */
inline constexpr double kFloatRoundoff = 0x1p-24;
inline constexpr double kDoubleRoundoff = 0x1p-53;

/** Sets the tolerance of `info` and adds it to its settings, so that every report shows
 it with its origin. Replaces a tolerance that was stated before.
 @throws std::invalid_argument if a part is negative or not finite, or if a tolerance that
 is not 0 has no source. */
void SetTolerance(StatedTolerance tolerance, OracleInfo& info);

/** Returns `oracle` under the same name, judged with `tolerance`. The answers are those
 of `oracle`, which must live longer. Throws like SetTolerance(). */
std::unique_ptr<Oracle> WithTolerance(const Oracle& oracle, StatedTolerance tolerance);

/** Returns the tolerance in words: "0.0001 m and 1e-06 of the scene's size". */
std::string ToString(const StatedTolerance& tolerance);

}  // namespace touchstone
