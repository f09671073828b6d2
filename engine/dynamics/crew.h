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

  /** The time in which work is shared. The threads stay awake from one task to the next,
   since to wake one takes some 30 microseconds; they leave their processors to others
   that want them. */
  class Shift {
   public:
    /** With fewer things to do than `least` there is none. */
    Shift(Crew& crew, std::size_t count, std::size_t least);
    ~Shift();
    Shift(const Shift&) = delete;
    Shift& operator=(const Shift&) = delete;

   private:
    Crew& crew_;
  };

  /** Calls `work(begin, end)` so that every index in [0, count) is in one of the calls,
   and returns when all have returned. Fewer than `least`, and all outside a Shift, are
   done by the caller. `work` does not throw. */
  template <class Work>
  void Share(std::size_t count, std::size_t least, const Work& work) {
    ShareOut(count, least,
             [&](std::size_t, std::size_t begin, std::size_t end) { work(begin, end); });
  }

  /** The same for `work(share, begin, end)`: calls of a greater share, all less than
   shares(), have greater indices, and no two calls the same share. */
  template <class Work>
  void ShareOut(std::size_t count, std::size_t least, const Work& work) {
    if (count < least || !on_shift_.load(std::memory_order_relaxed)) {
      if (count > 0) work(std::size_t{0}, std::size_t{0}, count);
      return;
    }
    Run(count, &work,
        [](const void* object, std::size_t share, std::size_t begin, std::size_t end) {
          (*static_cast<const Work*>(object))(share, begin, end);
        });
  }

  std::size_t shares() const { return workers_.size() + 1; }

 private:
  using Call = void (*)(const void* object, std::size_t share, std::size_t begin,
                        std::size_t end);

  void Run(std::size_t count, const void* object, Call call);
  void DoShare(std::size_t share) const;
  void Serve(std::size_t share);
  /** Returns once `value` is not `old`. */
  void WaitWhile(const std::atomic<unsigned>& value, unsigned old) const;

  std::vector<std::thread> workers_;
  std::atomic<unsigned> task_{0};     ///< Counts the tasks that were given.
  std::atomic<unsigned> pending_{0};  ///< Workers that have not finished the last one.
  std::atomic<bool> on_shift_{false};
  std::atomic<bool> over_{false};
  std::size_t count_ = 0;
  const void* object_ = nullptr;
  Call call_ = nullptr;
};

}  // namespace cookbook
