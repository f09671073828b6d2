#pragma once

#include <chrono>
#include <cstdint>
#include <functional>

#include "reports/sweep/run_blocks.h"
#include "reports/sweep/sweep_file.h"

namespace touchstone {

/** The options of a sweep. */
struct SweepOptions {
  /** Number of threads; 0: one per core. The result does not depend on it. */
  int jobs = 0;
  Shard shard = {};
  Stop stop = nullptr;  ///< Same as BlockOptions::stop.
  /** Results are committed when this time has passed since the last commit, and fifty
   times as long as that took. A process that is killed loses no more. */
  std::chrono::milliseconds commit_after{1000};
  /** Called after each block with the numbers of questions (done, total) of the shard,
   from one thread at a time; may be empty. */
  std::function<void(std::uint64_t, std::uint64_t)> on_progress = nullptr;
};

/** Asks the questions of the blocks of a shard that `file` does not have yet, and commits
 the results to it. Returns whether the file now has all of them; false if it was stopped.
 Only the results of series in progress are in memory. Throws SweepFileError.
 @pre The file has SettingsOf(plan). */
bool Sweep(const SweepPlan& plan, SweepFile& file, const SweepOptions& options = {});

}  // namespace touchstone
