#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** How deep many spheres are in each other and in what is static, on average: √ of the
 mean over the samples of Σ depth² over all pairs (the "666" scenes of SimBenchmark, whose
 score is the square of it). [m]

 An engine that sees contacts once a step lets a pair V h + g h² deep, V the speed at
 which it approached where it could meet before the next sample: the tolerance is 1.5
 times the same mean of those. Where a `slope` s is named, the published score s h² of a
 hard solver, it is 1.5 √s h instead.

 About: spheres. Numbers: slope [m²/s²]. */
extern const Law kPenetrationScore;

}  // namespace touchstone
