#include "engine/threads/thread_pool.h"

namespace cookbook {
namespace {

/** How often a thread looks for news before it sleeps: some 40 microseconds, longer than
 to wake it takes, and than most of what a step leaves to one thread. */
constexpr int kLooks = 80'000;

/** The same where threads are more than processors: who looks takes another's. */
constexpr int kLooksOfMany = 100;

}  // namespace

ThreadPool::ParallelScope::ParallelScope(ThreadPool& pool, std::size_t count,
                                         std::size_t least)
    : pool_(pool) {
  pool.in_parallel_scope_ = !pool.workers_.empty() && count >= least;
}

ThreadPool::ParallelScope::~ParallelScope() {
  pool_.in_parallel_scope_ = false;
}

ThreadPool::ThreadPool(int threads)
    : claims_(static_cast<std::size_t>(threads)),
      looks_(static_cast<unsigned>(threads) > std::thread::hardware_concurrency()
                 ? kLooksOfMany
                 : kLooks) {
  try {
    for (std::size_t share = 1; share < shares(); ++share) {
      workers_.emplace_back([this, share] { WorkerLoop(share); });
    }
  } catch (...) {
    Stop();
    throw;
  }
}

ThreadPool::~ThreadPool() {
  Stop();
}

void ThreadPool::Stop() {
  over_ = true;
  task_.fetch_add(1, std::memory_order_release);
  task_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::WaitWhile(const std::atomic<unsigned>& value, unsigned old) const {
  for (int look = 0; look < looks_; ++look) {
    if (value.load(std::memory_order_acquire) != old) return;
  }
  value.wait(old, std::memory_order_acquire);
}

void ThreadPool::Run(std::size_t count, const void* object, Call call) noexcept {
  // No share of the last task is left: nobody reads these.
  count_ = count;
  object_ = object;
  call_ = call;
  done_.store(0, std::memory_order_relaxed);
  for (Claim& claim : claims_) claim.taken.store(false, std::memory_order_release);
  task_.fetch_add(1, std::memory_order_release);
  task_.notify_all();
  RunChunks(0);
  for (unsigned done = done_.load(std::memory_order_acquire); done != shares();
       done = done_.load(std::memory_order_acquire)) {
    WaitWhile(done_, done);
  }
}

void ThreadPool::RunChunks(std::size_t own) {
  for (std::size_t k = 0; k < shares(); ++k) {
    const std::size_t share = (own + k) % shares();
    std::atomic<bool>& taken = claims_[share].taken;
    if (taken.load(std::memory_order_relaxed) ||
        taken.exchange(true, std::memory_order_acquire)) {
      continue;
    }
    const std::size_t begin = count_ * share / shares();
    const std::size_t end = count_ * (share + 1) / shares();
    if (begin < end) call_(object_, share, begin, end);
    done_.fetch_add(1, std::memory_order_release);
    done_.notify_one();
  }
}

void ThreadPool::WorkerLoop(std::size_t own) {
  for (unsigned task = 0;;) {
    WaitWhile(task_, task);
    task = task_.load(std::memory_order_acquire);
    if (over_) return;
    RunChunks(own);
  }
}

}  // namespace cookbook
