#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace cookbook {

/** Two bodies that may meet in a step. */
struct ImpactCandidate {
  int A;
  int B;
  double gap;  ///< They are apart by so much or more when the step begins. [m]
  /** When they do; infinite: not in this step. [s] */
  double next = std::numeric_limits<double>::infinity();
  bool known = false;  ///< Whether the impact at hand knows if they touch.
  /** Of A and of B: the candidate appended before this one; −1: none. */
  std::array<int, 2> earlier;
};

/** What may meet in a step, and what meets next. */
class ImpactQueue {
 public:
  /** Begins a step of so many bodies: without candidates. */
  void Begin(std::size_t bodies);

  /** Forgets all candidates. */
  void Clear();

  /** Appends a candidate that does not meet. */
  void Append(int A, int B, double gap);

  /** Says that a candidate meets next at `time` [s]; infinite: not in this step. */
  void Schedule(int candidate, double time);

  /** Returns the candidate that meets next, the first of several at once; −1: none. */
  int TakeNext();

  int size() const { return static_cast<int>(candidates_.size()); }
  ImpactCandidate& operator[](int index) {
    return candidates_[static_cast<std::size_t>(index)];
  }
  const ImpactCandidate& operator[](int index) const {
    return candidates_[static_cast<std::size_t>(index)];
  }

  /** Calls `visit(index)` for the candidates that a body is one of, the last first. */
  template <class Visit>
  void ForEachOf(int body, const Visit& visit) const {
    for (int index = newest_[static_cast<std::size_t>(body)]; index >= 0;) {
      const ImpactCandidate& candidate = (*this)[index];
      const int next = candidate.earlier[candidate.A == body ? 0 : 1];
      visit(index);
      index = next;
    }
  }

 private:
  std::vector<ImpactCandidate> candidates_;
  std::vector<int> newest_;  ///< By body: its candidate appended last; −1: none.
  /** When candidates meet, and which: a island with the earliest first, in which some are
   out of date. */
  std::vector<std::pair<double, int>> queue_;
};

}  // namespace cookbook
