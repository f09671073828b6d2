#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "scenarios/contact_query.h"

namespace touchstone {

/** The ways in which a generated question is made harder. */
inline constexpr std::array<std::string_view, 7> kHardenings = {
    "as generated", "nearly touching", "flush",  "aligned",
    "scaled",       "far away",        "unequal"};

/** A question for a test of the referee. */
struct HardQuestion {
  ContactQuery query;
  std::string_view hardening;  ///< One of kHardenings.
};

/** Returns question `index` of the series `seed`, the same on every machine. 3,024
 questions in a row visit every family of scenarios/generators/generate.h, every ordered
 pair of shapes and every hardening:
  - nearly touching: B moved along the normal to a gap of ±10^-17 to ±10^-3 of the scene;
  - flush: like A rotated and, like A at a whole multiple of 2^-10 of the size, moved
    along an axis of A;
  - aligned: axes along those of the world, and all lengths whole multiples of an eighth,
    of few bits, so that nothing rounds and degenerate cases are exact;
  - scaled: all lengths multiplied by 10^-30 to 10^30;
  - far away: both moved by up to 10^8 times the size of the scene;
  - unequal: B scaled by 10^-6 to 10^6. */
HardQuestion HardQuestionAt(std::uint64_t seed, std::uint64_t index);

}  // namespace touchstone
