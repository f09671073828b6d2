#pragma once

#include <string>
#include <string_view>

#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns "apart", "touching" or "undecided". */
std::string_view NameOf(Touching touching);

/** Returns the shape, its sizes and its place: "sphere, radius 0.5 m at (1.2, 0, 0)". */
std::string Describe(const Body& body);

/** Returns the truth and its certificate as a sentence. */
std::string Describe(const ContactTruth& truth);

/** Returns the least error of `separation` that the enclosure of the truth leaves
 possible; NaN for NaN. [m] */
double LeastError(double separation, const ContactTruth& truth);

}  // namespace touchstone
