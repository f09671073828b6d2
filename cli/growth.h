#pragma once

#include <span>
#include <string>
#include <string_view>

namespace touchstone {

/** What a step of an oracle took in a scene of some size. */
struct TimeOfSize {
  std::string oracle;
  int bodies;
  double microseconds;
};

/** Returns k of the power law t ~ n^k through two times t at two sizes n:
 k = ln(t_b / t_a) / ln(n_b / n_a).
 @pre The sizes differ; they and the times are more than 0. */
double GrowthExponent(const TimeOfSize& a, const TimeOfSize& b);

/** Returns a table of GrowthExponent() with a row for each oracle, from each size to the
 next and, if that is not the same, from the least of at least 1,000 bodies to the
 greatest. Empty where no oracle has two such sizes.
 @param bodies What the bodies are: "boxes". */
std::string GrowthTable(std::string_view bodies, std::span<const TimeOfSize> times);

}  // namespace touchstone
