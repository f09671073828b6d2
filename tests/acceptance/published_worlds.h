#pragma once

#include <map>
#include <string>
#include <string_view>

#include "oracles/oracle.h"

namespace touchstone {

/** Returns what a public benchmark measures of an engine, by the names of the columns of
 published.csv, when `oracle` runs `benchmark` with steps of `dt` [s].

 | benchmark        | what it is, and where it comes from                              |
 |------------------|------------------------------------------------------------------|
 | bouncing         | SimBenchmark: an elastic ball falls 4.9 m, for 20 s              |
 | rolling 60 deg   | SimBenchmark: a plate with 25 balls on it is pulled, for 4 s     |
 | rolling 90 deg   | the same along y                                                 |
 | boxes simple     | scpeters/benchmark: a brick turns about one axis, for 10 s       |
 | boxes complex    | scpeters/benchmark: a brick tumbles as it flies, for 10 s        |
 | drop             | a dead ball falls 1 m and rests                                  |
 | slide 30 deg     | a block of 5 m/s slides to rest                                  |
 | slip and roll    | a ball of 5 m/s slides until it rolls                            |
 | cradle           | a ball hits four that touch, elastically                         |

 The worlds are simulated in this process. */
std::map<std::string, double> RunPublished(std::string_view benchmark,
                                           const Oracle& oracle, double dt);

}  // namespace touchstone
