#pragma once

#include <functional>
#include <vector>

#include "reports/worlds/law.h"
#include "reports/worlds/laws/worst.h"
#include "reports/worlds/truth/sliding.h"

namespace touchstone {

/** Judges bodies that rub on planes by Coulomb's circle. Where something is then beyond
 its tolerance, and the body follows another cone with nothing beyond, it is recognised as
 that: solvers with two friction directions are legal, and the closed forms of their cones
 are as sharp as the circle's.

 `judge_by` returns the findings of one body by one cone, always in the same order; a cone
 is placed on the plane that LandingOf() the body gives. */
std::vector<LawFinding> JudgedByCone(
    const Motion& motion, const std::vector<int>& bodies,
    const std::function<std::vector<Worst>(const PlacedCone&, const Motion&, int body)>&
        judge_by);

}  // namespace touchstone
