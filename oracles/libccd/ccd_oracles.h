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

 The translation does the following:
 - libccd has no shapes: the support functions are our own, after those of its README and
   test suite. There, a direction without a component along an axis selects the middle of
   the edge or face instead of a corner (ccdSign(0) = 0);
 - poses are applied as matrices, while the functions of the README use quaternions;
 - MPR starts from the bodies' origins, for a hull from the mean of its vertices;
 - the direction moves B out of A, from A to B: unchanged, NaN included;
 - the depth is positive when penetrating: negated;
 - the position is somewhere in the overlap, on no surface: unchanged;
 - max_iterations is 2^64 − 1 by default: set to 500, as in ODE and FCL. EPA ignores it;
 - the tolerances are 1e-4 by default: set to 1e-6, as in ODE and FCL.

 Half-spaces are unsupported: they have no support function. For pairs that are apart
 libccd returns no distance. Source: ccd/ccd.h of libccd 2.1, and measurement. */
std::vector<std::unique_ptr<Oracle>> CcdOracles();

}  // namespace touchstone
