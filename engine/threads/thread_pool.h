#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace cookbook {

/** Threads that share work with the one that calls them. What is done in one share must
 not depend on another: so the bits are the same whatever the number of threads. Each
 takes its own share first, and then those that nobody has begun: a thread without a
 processor keeps nobody waiting. */
class ThreadPool {
 public:
  /** `threads`: how many work at once, the caller included; at least 1.
   @throws std::system_error where the system does not give so many. */
  explicit ThreadPool(int threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  /** The time in which work is shared: else it does not pay to wake the threads, which
   takes some 30 microseconds each time. No two at once. */
  class ParallelScope {
   public:
    /** With fewer things to do than `least` there is none. */
    ParallelScope(ThreadPool& pool, std::size_t count, std::size_t least);
    ~ParallelScope();
    ParallelScope(const ParallelScope&) = delete;
    ParallelScope& operator=(const ParallelScope&) = delete;

   private:
    ThreadPool& pool_;
  };

  /** Calls `work(begin, end)` so that every index in [0, count) is in one of the calls,
   and returns when all have returned. Fewer than `least`, and all outside a
   ParallelScope, are done by the caller. `work` neither throws nor shares. */
  template <class Work>
  void ParallelFor(std::size_t count, std::size_t least, const Work& work) {
    ParallelForIndexed(
        count, least,
        [&](std::size_t, std::size_t begin, std::size_t end) { work(begin, end); });
  }

  /** The same for `work(share, begin, end)`: calls of a greater share, all less than
   shares(), have greater indices, and no two calls the same share. */
  template <class Work>
  void ParallelForIndexed(std::size_t count, std::size_t least, const Work& work) {
    if (count < least || !in_parallel_scope_) {
      if (count > 0) work(std::size_t{0}, std::size_t{0}, count);
      return;
    }
    Run(count, &work,
        [](const void* object, std::size_t share, std::size_t begin, std::size_t end) {
          (*static_cast<const Work*>(object))(share, begin, end);
        });
  }

  std::size_t shares() const { return claims_.size(); }

 private:
  using Call = void (*)(const void* object, std::size_t share, std::size_t begin,
                        std::size_t end);

  /** Whether somebody has begun a share; in a line of a cache of its own. */
  struct alignas(64) Claim {
    std::atomic<bool> taken{true};
  };

  void Run(std::size_t count, const void* object, Call call) noexcept;
  void Stop();
  /** Does what nobody has begun of the task, the share `own` first. */
  void RunChunks(std::size_t own);
  void WorkerLoop(std::size_t own);
  /** Returns once `value` is not `old`. */
  void WaitWhile(const std::atomic<unsigned>& value, unsigned old) const;

  std::vector<Claim> claims_;  ///< By share.
  int looks_;                  ///< How often a thread looks for news before it sleeps.
  bool in_parallel_scope_ = false;
  std::atomic<unsigned> task_{0};  ///< Counts the tasks that were given.
  std::atomic<unsigned> done_{0};  ///< Shares of the last one.
  std::atomic<bool> over_{false};
  std::size_t count_ = 0;
  const void* object_ = nullptr;
  Call call_ = nullptr;
  std::vector<std::thread> workers_;
};

}  // namespace cookbook
