#pragma once

#include <string>

#include "reports/worlds/curves.h"

namespace touchstone {

/** Draws the curves of `set` over time as an SVG element: one line an oracle with the
 class line0, line1, … of reports/writers/page.css in the order of the oracles, the truth
 dashed with a band of ± `band` about it [unit of the set; 0: none], the extremes of both
 axes as labels. Lines are thinned to what the eye can tell. */
std::string Plot(const CurveSet& set, double band);

}  // namespace touchstone
