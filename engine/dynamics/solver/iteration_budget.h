#pragma once

#include <algorithm>

#include "engine/dynamics/body/settings.h"

namespace cookbook {

/** The number of iterations × constraints that the solves of a small world may spend:
 Settings::iteration_budget on average. A solve may overdraw the budget by up to 20 times
 that, which later solves save again. */
class IterationBudget {
 public:
  /** Returns the amount that the next solve may spend. */
  long Remaining(const Settings& settings) const {
    return settings.iteration_budget +
           std::max(0L, kMaxOverdraft * settings.iteration_budget - overdraft_);
  }

  /** Records the amount that a solve spent. */
  void Spend(long spent, const Settings& settings) {
    overdraft_ = std::max(0L, overdraft_ + spent - settings.iteration_budget);
  }

 private:
  /** In multiples of Settings::iteration_budget. */
  static constexpr long kMaxOverdraft = 20;

  long overdraft_ = 0;  ///< Amount spent beyond the average and not saved yet.
};

}  // namespace cookbook
