#include "engine/dynamics/crew.h"

namespace cookbook {
namespace {

/** How often a thread that is not on a shift looks for news before it sleeps, and one
 that is before it leaves its processor to others: some microseconds. */
constexpr int kLooks = 4000;

}  // namespace

Crew::Shift::Shift(Crew& crew, std::size_t count, std::size_t least) : crew_(crew) {
  if (crew.workers_.empty() || count < least) return;
  crew.on_shift_.store(true, std::memory_order_relaxed);
}

Crew::Shift::~Shift() {
  crew_.on_shift_.store(false, std::memory_order_relaxed);
}

void Crew::WaitWhile(const std::atomic<unsigned>& value, unsigned old) const {
  for (int look = 0; look < kLooks || on_shift_.load(std::memory_order_relaxed);) {
    if (value.load(std::memory_order_acquire) != old) return;
    if (look < kLooks) {
      ++look;
    } else {
      std::this_thread::yield();
    }
  }
  while (value.load(std::memory_order_acquire) == old) {
    value.wait(old, std::memory_order_acquire);
  }
}

Crew::Crew(int threads) {
  for (int share = 1; share < threads; ++share) {
    workers_.emplace_back([this, share] { Serve(static_cast<std::size_t>(share)); });
  }
}

Crew::~Crew() {
  over_ = true;
  task_.fetch_add(1, std::memory_order_release);
  task_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void Crew::Run(std::size_t count, const void* object, Call call) {
  count_ = count;
  object_ = object;
  call_ = call;
  pending_.store(static_cast<unsigned>(workers_.size()), std::memory_order_relaxed);
  task_.fetch_add(1, std::memory_order_release);
  task_.notify_all();
  DoShare(0);
  for (unsigned left = pending_.load(std::memory_order_acquire); left != 0;
       left = pending_.load(std::memory_order_acquire)) {
    WaitWhile(pending_, left);
  }
}

void Crew::DoShare(std::size_t share) const {
  const std::size_t begin = count_ * share / shares();
  const std::size_t end = count_ * (share + 1) / shares();
  if (begin < end) call_(object_, share, begin, end);
}

void Crew::Serve(std::size_t share) {
  for (unsigned done = 0;;) {
    WaitWhile(task_, done);
    if (over_) return;
    ++done;
    DoShare(share);
    pending_.fetch_sub(1, std::memory_order_release);
    pending_.notify_one();
  }
}

}  // namespace cookbook
