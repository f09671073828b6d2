#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "reports/worlds/law_support/law.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/truth/sliding.h"

namespace touchstone {

/** Above √2, the ratio of the box's corner to its side. [-] */
inline constexpr double kRough = 2;

/** Returns the world with kRough times the friction at every contact. */
World Rougher(World world);

/** Returns whether `model` is the name of a friction cone. */
bool IsFrictionCone(std::string_view model);

/** Judges bodies with friction on planes by Coulomb's circular cone.

 A body beyond the circle's tolerance that follows another cone within tolerance is
 recognised as that cone. Solvers with two friction directions are legal, and the closed
 forms of their cones are as sharp as the circle's. It is not recognised if a circle with
 kRough times the friction explains the motion too. A body at rest, or a contact that does
 not slip, shows no cone, only that there is enough friction.

 `judge_by` returns the findings of one body for one cone, always in the same order. A
 cone is placed on the plane that LandingOf() returns for the body. */
std::vector<LawFinding> JudgedByCone(
    const Motion& motion, const std::vector<int>& bodies,
    const std::function<std::vector<Worst>(const PlacedCone&, const Motion&, int body)>&
        judge_by);

}  // namespace touchstone
