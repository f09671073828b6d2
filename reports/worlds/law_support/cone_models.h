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

/** Judges a motion with friction by Coulomb's circular cone, `cones.front()`.

 A motion beyond the circle's tolerance that follows another of the cones within tolerance
 is recognised as that cone. Solvers with two friction directions are legal, and the
 closed forms of their cones are as sharp as the circle's. It is not recognised if a
 circle with kRough times the friction explains the motion too. A body at rest, or a
 contact that does not slip, shows no cone, only that there is enough friction.

 `judge_by` returns the findings for one cone, always in the same order; `by_rougher`
 those for the circle with kRough times the friction. */
std::vector<LawFinding> JudgedByCone(
    const std::vector<PlacedCone>& cones,
    const std::function<std::vector<Worst>(const PlacedCone&)>& judge_by,
    const std::function<std::vector<Worst>()>& by_rougher);

/** Judges each of `bodies` in this way; a cone is placed on the plane that LandingOf()
 returns for the body. */
std::vector<LawFinding> JudgedByCone(
    const Motion& motion, const std::vector<int>& bodies,
    const std::function<std::vector<Worst>(const PlacedCone&, const Motion&, int body)>&
        judge_by);

}  // namespace touchstone
