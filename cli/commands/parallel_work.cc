#include "cli/commands/parallel_work.h"

#include <mutex>

#include "cli/progress_bar.h"
#include "reports/threads/parallel_for.h"

namespace touchstone {

std::size_t ForEachInParallel(const ParallelWork& work, std::size_t count,
                              const std::function<void(std::size_t)>& piece) {
  ProgressBar bar(work.terminal, work.quiet);
  std::mutex mutex;
  std::size_t done = 0;
  std::size_t left_out = 0;
  ParallelFor(count, work.jobs, [&](std::size_t i) {
    const bool is_over = work.stop();
    if (!is_over) piece(i);
    const std::scoped_lock lock(mutex);
    if (is_over) ++left_out;
    bar.Show(++done, count);
  });
  return left_out;
}

}  // namespace touchstone
