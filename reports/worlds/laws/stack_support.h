#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** In a stack at rest each level carries what is above it: the contacts between level k −
 1 and level k give Σ_{i >= k} m_i g along gravity. [N]

 Mean over the second half of the motion, of duration T. Whatever the solver does,
 momentum balances: the mean is off by the momentum that what is above gains in T, over T,
 × 1.5; and at rest that is at most the contacts' 2 g h a level (laws/rests.h), at both
 ends of T. Plus 64 roundings a step.

 Speaks only of engines that give their impulses. About: bodies from the lowest to the
 highest, each on the one before, the first on what is static. Numbers: expected_weight of
 all [N]. */
extern const Law kStackSupport;

}  // namespace touchstone
