#pragma once

#include <algorithm>

#include "engine/dynamics/body/settings.h"

namespace cookbook {

/** The extra work, iterations × constraints, that solves may spend beyond their first
 Settings::impulse_iterations iterations. On average it is what these leave of
 Settings::iteration_budget. A solve may overdraw that by up to 30 times, which later
 solves save again. With more constraints the extra work falls continuously to 0. */
class IterationBudget {
 public:
  /** Returns the extra work that the next solve may spend. */
  long Remaining(const Settings& settings, int constraints) const {
    const long average = Average(settings, constraints);
    return average + std::max(0L, kMaxOverdraft * average - overdraft_);
  }

  /** Records the extra work that a solve spent. */
  void Spend(long spent, const Settings& settings, int constraints) {
    overdraft_ = std::max(0L, overdraft_ + spent - Average(settings, constraints));
  }

 private:
  /** In multiples of the average. */
  static constexpr long kMaxOverdraft = 30;

  static long Average(const Settings& settings, int constraints) {
    return std::max(
        0L, settings.iteration_budget - long{settings.impulse_iterations} * constraints);
  }

  long overdraft_ = 0;  ///< Amount spent beyond the average and not saved yet.
};

}  // namespace cookbook
