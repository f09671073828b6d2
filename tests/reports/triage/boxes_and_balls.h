#pragma once

#include <string>
#include <vector>

#include "reports/triage/examine.h"
#include "reports/triage/root.h"
#include "scenarios/scenario.h"

namespace touchstone {

/** Returns a box with half extents of 1 m, and B at `p_WB` beside it. */
Scenario BoxAnd(Shape B, const Eigen::Vector3d& p_WB);

/** Returns the symptom that `oracle` shows in `scenario`, found in 5 of 100 questions.
 @pre It fails there. */
Symptom SymptomIn(const Scenario& scenario, const Oracle& oracle);

/** Returns the smallest question found for that symptom. */
Specimen SmallestIn(const Scenario& scenario, const Oracle& oracle);

/** Returns the roots of `specimens` among 100 questions of a box and a sphere of each of
 the families random and deep, and 50 of a box and a cone. */
std::vector<Root> RootsAmongBoxesAndBalls(std::vector<Specimen> specimens);

}  // namespace touchstone
