#pragma once

#include <cstdint>
#include <functional>

#include "reports/sweep/sweep_plan.h"
#include "reports/sweep/tally.h"
#include "reports/threads/stop.h"

namespace touchstone {

/** A part of the blocks of a sweep: those whose number is index modulo count. */
struct Shard {
  std::uint64_t index = 0;
  std::uint64_t count = 1;

  bool Contains(std::uint64_t block) const { return block % count == index; }
  /** Returns the number of its blocks among [0, blocks). */
  std::uint64_t SizeOf(std::uint64_t blocks) const {
    return blocks / count + (blocks % count > index ? 1 : 0);
  }
};

/** The way in which blocks are computed. */
struct BlockOptions {
  int jobs = 0;  ///< Number of threads; 0: one per core.
  Shard shard = {};
  /** Returns whether the result of a block is known already; may be empty. */
  std::function<bool(std::uint64_t block)> is_done = nullptr;
  Stop stop = nullptr;  ///< Blocks in progress are then dropped.
};

/** Computes the blocks of a shard in several threads, and passes each result to `take`,
 from one thread at a time, in no particular order. An exception of `take` stops the work
 and is rethrown. */
void RunBlocks(
    const SweepPlan& plan, const BlockOptions& options,
    const std::function<void(std::uint64_t block, const SeriesTally& result)>& take);

}  // namespace touchstone
