#pragma once

#include <map>
#include <string>
#include <string_view>

#include "oracles/oracle.h"

namespace touchstone {

/** Returns the quantities that a public benchmark measures, by their names in
 published.csv, when `oracle` runs `benchmark` with steps of `dt` [s].

 | benchmark        | world and source                                                 |
 |------------------|------------------------------------------------------------------|
 | bouncing         | SimBenchmark: an elastic ball falls 4.9 m, for 20 s              |
 | rolling 60 deg   | SimBenchmark: a force drags a plate with 25 balls on it, for 4 s |
 | rolling 90 deg   | the same along y                                                 |
 | boxes simple     | scpeters/benchmark: a brick turns about one axis, for 10 s       |
 | boxes complex    | scpeters/benchmark: a brick tumbles in free flight, for 10 s     |
 | drop             | an inelastic ball falls 1 m and rests                            |
 | slide 30 deg     | a block slides from 5 m/s to rest                                |
 | slip and roll    | a ball of 5 m/s slides until it rolls                            |
 | cradle           | a ball hits four touching balls elastically                      |

 The worlds are simulated in this process. */
std::map<std::string, double> RunPublished(std::string_view benchmark,
                                           const Oracle& oracle, double dt);

}  // namespace touchstone
