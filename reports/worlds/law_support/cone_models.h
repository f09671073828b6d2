#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "reports/worlds/law_support/law.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/truth/sliding.h"

namespace touchstone {

inline constexpr double kRough = 2;  ///< Beyond √2, the box's corner over its side. [-]

/** Returns the world with kRough times the friction at every contact. */
World Rougher(World world);

/** Returns whether `model` is the name of a friction cone. */
bool IsFrictionCone(std::string_view model);

/** Judges bodies that rub on planes by Coulomb's circle. Where something is then beyond
 its tolerance, and the body follows another cone with nothing beyond, it is recognised as
 that: solvers with two friction directions are legal, and the closed forms of their cones
 are as sharp as the circle's. Not where a circle of kRough times the friction leads there
 too: what rests, or a contact that does not slip, shows no cone, only that there is
 enough friction.

 `judge_by` returns the findings of one body by one cone, always in the same order; a cone
 is placed on the plane that LandingOf() the body gives. */
std::vector<LawFinding> JudgedByCone(
    const Motion& motion, const std::vector<int>& bodies,
    const std::function<std::vector<Worst>(const PlacedCone&, const Motion&, int body)>&
        judge_by);

}  // namespace touchstone
