#include "engine/threads/thread_pool.h"

namespace cookbook {
namespace {

/** Number of polls before a waiting thread sleeps, about 40 microseconds. That is longer
 than waking a thread takes, and longer than most serial parts of a step. */
constexpr int kSpinCount = 80'000;

/** The same if there are more threads than processors: a polling thread then keeps
 another one from running. */
constexpr int kSpinCountOversubscribed = 100;

}  // namespace

ThreadPool::ParallelScope::ParallelScope(ThreadPool& pool, std::size_t count,
                                         std::size_t min_count)
    : pool_(pool) {
  pool.in_parallel_scope_ = !pool.workers_.empty() && count >= min_count;
}

ThreadPool::ParallelScope::~ParallelScope() {
  pool_.in_parallel_scope_ = false;
}

ThreadPool::ThreadPool(int threads)
    : claims_(static_cast<std::size_t>(threads)),
      spin_count_(static_cast<unsigned>(threads) > std::thread::hardware_concurrency()
                      ? kSpinCountOversubscribed
                      : kSpinCount) {
  try {
    for (std::size_t chunk = 1; chunk < chunk_count(); ++chunk) {
      workers_.emplace_back([this, chunk] { WorkerLoop(chunk); });
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
  stopping_ = true;
  loop_.fetch_add(1, std::memory_order_release);
  loop_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::WaitWhile(const std::atomic<unsigned>& value, unsigned old) const {
  for (int spin = 0; spin < spin_count_; ++spin) {
    if (value.load(std::memory_order_acquire) != old) return;
  }
  value.wait(old, std::memory_order_acquire);
}

void ThreadPool::Run(std::size_t count, const void* object, Call call) noexcept {
  // All chunks of the last loop are taken, so no thread reads these members.
  count_ = count;
  object_ = object;
  call_ = call;
  chunks_done_.store(0, std::memory_order_relaxed);
  for (Claim& claim : claims_) claim.taken.store(false, std::memory_order_release);
  loop_.fetch_add(1, std::memory_order_release);
  loop_.notify_all();
  RunChunks(0);
  for (unsigned done = chunks_done_.load(std::memory_order_acquire);
       done != chunk_count(); done = chunks_done_.load(std::memory_order_acquire)) {
    WaitWhile(chunks_done_, done);
  }
}

void ThreadPool::RunChunks(std::size_t first) {
  for (std::size_t k = 0; k < chunk_count(); ++k) {
    const std::size_t chunk = (first + k) % chunk_count();
    std::atomic<bool>& taken = claims_[chunk].taken;
    if (taken.load(std::memory_order_relaxed) ||
        taken.exchange(true, std::memory_order_acquire)) {
      continue;
    }
    const std::size_t begin = count_ * chunk / chunk_count();
    const std::size_t end = count_ * (chunk + 1) / chunk_count();
    if (begin < end) call_(object_, chunk, begin, end);
    chunks_done_.fetch_add(1, std::memory_order_release);
    chunks_done_.notify_one();
  }
}

void ThreadPool::WorkerLoop(std::size_t own_chunk) {
  for (unsigned loop = 0;;) {
    WaitWhile(loop_, loop);
    loop = loop_.load(std::memory_order_acquire);
    if (stopping_) return;
    RunChunks(own_chunk);
  }
}

}  // namespace cookbook
