#pragma once

#include <cstddef>
#include <string>

#include "reports/worlds/study/curves.h"

namespace touchstone {

/** Returns the class of reports/writers/page.css that the line of an oracle has: line0 of
 the first, the subject, then line1 to line8 over and over. */
std::string LineClass(std::size_t oracle);

/** Draws the curves of `set` over time as an SVG element: one line an oracle with its
 LineClass() in the order of the oracles, the truth
 dashed with a band of ± `band` about it [unit of the set; 0: none], the extremes of both
 axes as labels, the lesser of values that print alike by its difference. Lines are
 thinned to what the eye can tell. */
std::string Plot(const CurveSet& set, double band);

}  // namespace touchstone
