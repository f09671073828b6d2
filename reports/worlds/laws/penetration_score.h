#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** The mean penetration of many spheres in each other and in static bodies: √ of the mean
 over the samples of Σ depth² over all pairs (the "666" scenes of SimBenchmark, whose
 score is the square of it). [m]

 An engine that detects contacts once per step lets a pair penetrate by V h + g h². V is
 the speed of approach at samples after which the pair could touch before the next, at
 most what the truth allows. The tolerance is 1.5 times the same mean of those depths. If
 a `slope` s is given, the published score s h² of a hard solver, the tolerance is 1.5 √s
 h instead.

 About: spheres. Numbers: slope [m²/s²]. */
extern const Law kPenetrationScore;

}  // namespace touchstone
