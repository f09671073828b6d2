#include "reports/sweep/run_blocks.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <optional>

#include "reports/sweep/ask_block.h"
#include "reports/threads/parallel_for.h"

namespace touchstone {

void RunBlocks(
    const SweepPlan& plan, const BlockOptions& options,
    const std::function<void(std::uint64_t block, const SeriesTally& result)>& take) {
  std::mutex taking;
  std::exception_ptr error;
  std::atomic<bool> failed = false;
  ParallelFor(options.shard.SizeOf(BlockCount(plan)), options.jobs, [&](std::size_t i) {
    const std::uint64_t block = options.shard.index + i * options.shard.count;
    if (failed || IsStopped(options.stop)) return;
    if (options.is_done && options.is_done(block)) return;
    const std::optional<SeriesTally> result =
        AskBlock(plan, BlockOf(plan, block), options.stop);
    const std::scoped_lock lock(taking);
    if (failed || !result) return;
    try {
      take(block, *result);
    } catch (...) {
      error = std::current_exception();
      failed = true;
    }
  });
  if (error) std::rethrow_exception(error);
}

}  // namespace touchstone
