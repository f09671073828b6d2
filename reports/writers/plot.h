#pragma once

#include <cstddef>
#include <string>

#include "reports/worlds/study/curves.h"

namespace touchstone {

/** Returns the class of reports/writers/page.css for the line of an oracle: line0 for the
 first, the subject, then line1 to line8 in turn. From the second turn on, "again" is
 added, which makes the line dashed. */
std::string LineClass(std::size_t oracle);

/** Draws the curves of `set` over time as an SVG element. Each oracle has a line with its
 LineClass(), in the order of the oracles. The truth is dashed, with a band of ± `band`
 around it [unit of the set; 0: none]. The labels are the extremes of both axes; where the
 extremes of the values print alike, the lower one is stated by its difference. Lines are
 reduced to as many points as the eye can resolve. */
std::string Plot(const CurveSet& set, double band);

}  // namespace touchstone
