#include "engine/dynamics/impacts/impact_queue.h"

#include <algorithm>
#include <functional>

namespace cookbook {

void ImpactQueue::Begin(std::size_t bodies) {
  Clear();
  newest_.assign(bodies, -1);
}

void ImpactQueue::Clear() {
  candidates_.clear();
  queue_.clear();
}

void ImpactQueue::Append(int A, int B, double gap) {
  int& of_A = newest_[static_cast<std::size_t>(A)];
  int& of_B = newest_[static_cast<std::size_t>(B)];
  candidates_.push_back({.A = A, .B = B, .gap = gap, .earlier = {of_A, of_B}});
  of_A = of_B = size() - 1;
}

void ImpactQueue::Schedule(int candidate, double time) {
  (*this)[candidate].next = time;
  if (time == std::numeric_limits<double>::infinity()) return;
  queue_.emplace_back(time, candidate);
  std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
}

int ImpactQueue::TakeNext() {
  while (!queue_.empty()) {
    std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
    const auto [time, index] = queue_.back();
    queue_.pop_back();
    if ((*this)[index].next == time) return index;
  }
  return -1;
}

}  // namespace cookbook
