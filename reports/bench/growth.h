#pragma once

#include <span>
#include <string>
#include <string_view>

namespace touchstone {

/** The time per step of an oracle in a scene of some size. */
struct TimeOfSize {
  std::string oracle;
  int bodies;
  double microseconds;
};

/** Returns k of the power law t ~ n^k through two times t at two sizes n:
 k = ln(t_b / t_a) / ln(n_b / n_a).
 @pre The sizes differ; sizes and times are positive. */
double GrowthExponent(const TimeOfSize& a, const TimeOfSize& b);

/** Returns a table of GrowthExponent() with a row for each oracle. A column spans each
 two neighbouring sizes. If at least three sizes have 1,000 bodies or more, a last column
 spans all of those. Empty if no oracle has two such sizes.
 @param bodies Plural of the kind of body, e.g. "boxes". */
std::string GrowthTable(std::string_view bodies, std::span<const TimeOfSize> times);

}  // namespace touchstone
