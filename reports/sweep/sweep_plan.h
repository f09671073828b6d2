#pragma once

#include <cstdint>
#include <vector>

#include "oracles/oracle.h"
#include "reports/sweep/series.h"

namespace touchstone {

/** The questions of a sweep, and the oracles that it asks. */
struct SweepPlan {
  std::vector<Series> series;
  std::vector<const Oracle*> subjects;
  /** Oracles that answer every contact question too, and so take part in the consensus on
   questions that the truth cannot decide. They are not counted. */
  std::vector<const Oracle*> references = {};
};

/** A block of a plan. The blocks of all series are numbered one after the other, so that
 the numbers depend on the plan alone. */
struct SweepBlock {
  std::size_t series;  ///< Index into SweepPlan::series.
  Series questions;
  std::uint64_t number;  ///< Number of the block in its series.
};

/** Returns the number of blocks of all series. */
std::uint64_t BlockCount(const SweepPlan& plan);

/** Returns block `number`. @pre number < BlockCount(plan). */
SweepBlock BlockOf(const SweepPlan& plan, std::uint64_t number);

}  // namespace touchstone
