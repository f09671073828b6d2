#include <algorithm>

#include "reports/shrink/reductions.h"

namespace touchstone {

void FewerSteps(const Question& question, const Candidates& take) {
  const auto* const scenario = std::get_if<WorldScenario>(&question);
  if (scenario == nullptr) return;
  const auto add = [&](int steps, int sample_every) {
    if (steps < 1 || sample_every < 1) return;
    WorldScenario shorter = *scenario;
    shorter.world.steps = steps;
    shorter.world.sample_every = std::min(sample_every, steps);
    take(std::move(shorter));
  };
  const int steps = scenario->world.steps;
  const int every = scenario->world.sample_every;
  // 1 step, then ever longer parts of the present duration: the shortest wins.
  for (int n = 1; n < steps; n *= 2) add(n, every);
  for (const int percent : {60, 75, 90, 95, 99}) add(steps * percent / 100, every);
  add(steps - every, every);
  add(steps - 1, every);
  add(steps, steps);
}

}  // namespace touchstone
