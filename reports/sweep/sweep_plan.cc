#include "reports/sweep/sweep_plan.h"

namespace touchstone {

std::uint64_t BlockCount(const SweepPlan& plan) {
  std::uint64_t sum = 0;
  for (const Series& series : plan.series) sum += BlockCount(series);
  return sum;
}

SweepBlock BlockOf(const SweepPlan& plan, std::uint64_t number) {
  std::size_t series = 0;
  while (number >= BlockCount(plan.series[series])) {
    number -= BlockCount(plan.series[series]);
    ++series;
  }
  return {series, BlockOf(plan.series[series], number), number};
}

}  // namespace touchstone
