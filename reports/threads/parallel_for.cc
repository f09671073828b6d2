#include "reports/threads/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "oracles/standard_arithmetic.h"

namespace touchstone {

void ParallelFor(std::size_t count, int jobs,
                 const std::function<void(std::size_t)>& work) {
  const auto cores = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t threads =
      std::min(count, jobs > 0 ? static_cast<std::size_t>(jobs) : cores);
  std::atomic<std::size_t> next = 0;
  const auto take = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      const StandardArithmetic arithmetic;
      work(i);
    }
  };
  if (threads <= 1) {
    take();
    return;
  }
  std::vector<std::jthread> workers;
  for (std::size_t i = 0; i < threads; ++i) workers.emplace_back(take);
}

}  // namespace touchstone
