#pragma once

#include <algorithm>

#include "engine/dynamics/body/settings.h"

namespace cookbook {

/** How much the solves of a small world may spend, in sweeps × rows: on the average
 Settings::iteration_budget, and ahead of others up to 20 times as much. */
class IterationBudget {
 public:
  /** Returns what the next solve may spend. */
  long Left(const Settings& settings) const {
    return settings.iteration_budget +
           std::max(0L, kHeadStart * settings.iteration_budget - ahead_);
  }

  /** Says what it spent. */
  void Spend(long spent, const Settings& settings) {
    ahead_ = std::max(0L, ahead_ + spent - settings.iteration_budget);
  }

 private:
  static constexpr long kHeadStart = 20;

  long ahead_ = 0;  ///< What was spent beyond the average, and not saved yet.
};

}  // namespace cookbook
