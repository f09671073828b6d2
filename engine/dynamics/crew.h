#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace cookbook {

/** Threads that share work with the one that calls them. The shares depend on the count
 alone, and what is done in one must not depend on another: so the bits are the same
 whatever the number of threads. */
class Crew {
 public:
  /** `threads`: how many work at once, the caller included; at least 1. */
  explicit Crew(int threads);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  /** Calls `work(begin, end)` so that every index in [0, count) is in one of the calls,
   and returns when all have returned. Fewer than `least` are done by the caller. `work`
   does not throw. */
  template <class Work>
  void Share(std::size_t count, std::size_t least, const Work& work) {
    if (workers_.empty() || count < least) {
      if (count > 0) work(std::size_t{0}, count);
      return;
    }
    Run(count, &work, [](const void* object, std::size_t begin, std::size_t end) {
      (*static_cast<const Work*>(object))(begin, end);
    });
  }

 private:
  using Call = void (*)(const void* object, std::size_t begin, std::size_t end);

  void Run(std::size_t count, const void* object, Call call);
  void DoShare(std::size_t share) const;
  void Serve(std::size_t share);

  std::vector<std::thread> workers_;
  std::atomic<unsigned> task_{0};     ///< Counts the tasks that were given.
  std::atomic<unsigned> pending_{0};  ///< Workers that have not finished the last one.
  std::atomic<bool> over_{false};
  std::size_t count_ = 0;
  const void* object_ = nullptr;
  Call call_ = nullptr;
};

}  // namespace cookbook
