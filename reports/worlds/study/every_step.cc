#include "reports/worlds/study/every_step.h"

#include <cstddef>

namespace touchstone {

World EveryStep(const World& world) {
  World every = world;
  every.sample_every = 1;
  return every;
}

Trajectory SampledAs(const World& world, const Trajectory& of_steps) {
  if (world.sample_every == 1) return of_steps;
  Trajectory sampled = of_steps;
  sampled.times.clear();
  sampled.samples.clear();
  const auto every = static_cast<std::size_t>(world.sample_every);
  for (std::size_t s = 0; s < of_steps.samples.size(); s += every) {
    sampled.times.push_back(of_steps.times[s]);
    sampled.samples.push_back(of_steps.samples[s]);
  }
  return sampled;
}

}  // namespace touchstone
