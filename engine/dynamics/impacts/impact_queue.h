#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace cookbook {

/** Two bodies that may collide in a step. */
struct ImpactCandidate {
  int A;
  int B;
  double gap;  ///< Lower bound of their distance at the start of the step. [m]
  /** Time of their next impact; infinite: none in this step. [s] */
  double time_of_impact = std::numeric_limits<double>::infinity();
  bool is_tested = false;  ///< Whether the current impact has tested them for contact.
  /** Index of the previous candidate of A and of B; −1: none. */
  std::array<int, 2> previous;
};

/** A priority queue of the impacts of a step, ordered by time, with a list of candidates
 for each body. A candidate may be rescheduled: entries of the binary heap are not removed
 then, but skipped when they come to the top. */
class ImpactQueue {
 public:
  /** Begins a step of a world of `bodies` bodies, without candidates. */
  void Begin(std::size_t bodies);

  /** Removes all candidates. */
  void Clear();

  /** Appends a candidate without an impact. */
  void Append(int A, int B, double gap);

  /** Sets the time of impact [s] of a candidate; infinite: none in this step. */
  void Schedule(int candidate, double time);

  /** Removes the earliest impact and returns its candidate; −1: none. Impacts at the same
   time come in the order of their candidates. */
  int PopEarliest();

  int size() const { return static_cast<int>(candidates_.size()); }
  ImpactCandidate& operator[](int index) {
    return candidates_[static_cast<std::size_t>(index)];
  }
  const ImpactCandidate& operator[](int index) const {
    return candidates_[static_cast<std::size_t>(index)];
  }

  /** Calls `visit(index)` for each candidate of a body, the last one first. */
  template <class Visit>
  void ForEachOf(int body, const Visit& visit) const {
    for (int index = last_candidate_[static_cast<std::size_t>(body)]; index >= 0;) {
      const ImpactCandidate& candidate = (*this)[index];
      const int next = candidate.previous[candidate.A == body ? 0 : 1];
      visit(index);
      index = next;
    }
  }

 private:
  std::vector<ImpactCandidate> candidates_;
  std::vector<int> last_candidate_;  ///< Indexed by body; −1: none.
  /** Binary heap of (time of impact, candidate), the earliest on top. Some entries are
   out of date. */
  std::vector<std::pair<double, int>> binary_heap_;
};

}  // namespace cookbook
