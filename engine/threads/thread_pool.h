#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace cookbook {

/** A thread pool for parallel loops. A loop is divided into as many chunks as there are
 threads. The calls for two chunks must not depend on each other; then the result has the
 same bits whatever the number of threads. Each thread runs its own chunk first, then any
 chunk that no thread has begun: a thread that has not begun a chunk delays nobody. */
class ThreadPool {
 public:
  /** `threads`: number of threads that work at the same time, including the caller; at
   least 1.
   @throws std::system_error if the system cannot start that many threads. */
  explicit ThreadPool(int threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  /** Loops are parallel only while such an object lives; otherwise they run serially.
   A scope is for loops that together take longer than waking the threads, which is about
   30 microseconds each time. Scopes of the same pool must not overlap. */
  class ParallelScope {
   public:
    /** Loops run in parallel only if `count`, the size of the problem, is at least
     `min_count`. */
    ParallelScope(ThreadPool& pool, std::size_t count, std::size_t min_count);
    ~ParallelScope();
    ParallelScope(const ParallelScope&) = delete;
    ParallelScope& operator=(const ParallelScope&) = delete;

   private:
    ThreadPool& pool_;
  };

  /** Calls `work(begin, end)` for each chunk of the indices in [0, count), and returns
   after all calls have returned. The caller alone makes one call for all indices if
   `count` is less than `min_count`, or outside of a ParallelScope. `work` must not throw,
   and must not start another loop. */
  template <class Work>
  void ParallelFor(std::size_t count, std::size_t min_count, const Work& work) {
    ParallelForIndexed(
        count, min_count,
        [&](std::size_t, std::size_t begin, std::size_t end) { work(begin, end); });
  }

  /** Like ParallelFor(), but calls `work(chunk, begin, end)`. Chunks are numbered in the
   order of their indices and are less than chunk_count(). No two calls have the same
   chunk. */
  template <class Work>
  void ParallelForIndexed(std::size_t count, std::size_t min_count, const Work& work) {
    if (count < min_count || !in_parallel_scope_) {
      if (count > 0) work(std::size_t{0}, std::size_t{0}, count);
      return;
    }
    Run(count, &work,
        [](const void* object, std::size_t chunk, std::size_t begin, std::size_t end) {
          (*static_cast<const Work*>(object))(chunk, begin, end);
        });
  }

  /** Returns the number of chunks of a parallel loop, which is the number of threads. */
  std::size_t chunk_count() const { return claims_.size(); }

 private:
  using Call = void (*)(const void* object, std::size_t chunk, std::size_t begin,
                        std::size_t end);

  /** Whether a thread has begun a chunk. Fills a cache line, against false sharing. */
  struct alignas(64) Claim {
    std::atomic<bool> taken{true};
  };

  void Run(std::size_t count, const void* object, Call call) noexcept;
  void Stop();
  /** Runs the chunks of the current loop that no thread has begun, `first` first. */
  void RunChunks(std::size_t first);
  void WorkerLoop(std::size_t own_chunk);
  /** Returns once `value` is not `old`. */
  void WaitWhile(const std::atomic<unsigned>& value, unsigned old) const;

  std::vector<Claim> claims_;  ///< Indexed by chunk.
  int spin_count_;             ///< Number of polls before a waiting thread sleeps.
  bool in_parallel_scope_ = false;
  std::atomic<unsigned> loop_{0};         ///< Number of loops started so far.
  std::atomic<unsigned> chunks_done_{0};  ///< Number of finished chunks of the last loop.
  std::atomic<bool> stopping_{false};
  std::size_t count_ = 0;
  const void* object_ = nullptr;
  Call call_ = nullptr;
  std::vector<std::thread> workers_;
};

}  // namespace cookbook
