#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** In a stack at rest each level carries everything above it: the contacts between level
 k − 1 and level k exert Σ_{i >= k} m_i g against gravity. [N]

 The force is the mean over the second half of the motion, of duration T. Momentum
 balances whatever the solver does. So the mean is off by the momentum that the levels
 from k on gain in T, over T, × 1.5. At rest that is at most the contacts' 2 g h per level
 (laws/rests.h), at both ends of T. 64 roundings per step are added.

 Judges only engines that report contact impulses. About: bodies from the lowest to the
 highest, each on its predecessor, the first on something static. Numbers: expected_weight
 of all [N]. */
extern const Law kStackSupport;

}  // namespace touchstone
