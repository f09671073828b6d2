#pragma once

#include <memory>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** Returns the oracles of libccd:

 | name       | entry point          | runs                         |
 |------------|----------------------|------------------------------|
 | libccd/epa | ccdGJKPenetration()  | isolated (isolated_oracle.h) |
 | libccd/mpr | ccdMPRPenetration()  | in process                   |

 What the translation hides:
 - libccd has no shapes: the support functions are ours, after those of its README and
 test suite, in which a direction without a component along an axis meets the middle of
 the edge or face and not a corner (ccdSign(0) = 0);
 - poses are applied as matrices, where those of the README go through quaternions;
 - MPR starts from the bodies' origins, from the mean of a hull's vertices;
 - the direction moves B out of A, from A to B: as it comes, NaN included;
 - the depth is positive when penetrating: negated;
 - the position is somewhere in the overlap, on no surface: as it comes;
 - max_iterations is 2^64 − 1 by default: 500, as in ODE and FCL. EPA does not heed it;
 - the tolerances are 1e-4 by default: 1e-6, as in ODE and FCL.

 Half-spaces have no support. libccd says nothing of pairs that are apart. Source:
 ccd/ccd.h of libccd 2.1, and measurement. */
std::vector<std::unique_ptr<Oracle>> CcdOracles();

}  // namespace touchstone
