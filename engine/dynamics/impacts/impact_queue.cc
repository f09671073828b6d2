#include "engine/dynamics/impacts/impact_queue.h"

#include <algorithm>
#include <functional>

namespace cookbook {

void ImpactQueue::Begin(std::size_t bodies) {
  Clear();
  last_candidate_.assign(bodies, -1);
}

void ImpactQueue::Clear() {
  candidates_.clear();
  binary_heap_.clear();
}

void ImpactQueue::Append(int A, int B, double gap) {
  int& last_of_A = last_candidate_[static_cast<std::size_t>(A)];
  int& last_of_B = last_candidate_[static_cast<std::size_t>(B)];
  candidates_.push_back({.A = A, .B = B, .gap = gap, .previous = {last_of_A, last_of_B}});
  last_of_A = last_of_B = size() - 1;
}

void ImpactQueue::Schedule(int candidate, double time) {
  (*this)[candidate].time_of_impact = time;
  if (time == std::numeric_limits<double>::infinity()) return;
  binary_heap_.emplace_back(time, candidate);
  std::push_heap(binary_heap_.begin(), binary_heap_.end(), std::greater<>());
}

int ImpactQueue::PopEarliest() {
  while (!binary_heap_.empty()) {
    std::pop_heap(binary_heap_.begin(), binary_heap_.end(), std::greater<>());
    const auto [time, index] = binary_heap_.back();
    binary_heap_.pop_back();
    if ((*this)[index].time_of_impact == time) return index;
  }
  return -1;
}

}  // namespace cookbook
