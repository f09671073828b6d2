#include "reports/worlds/study/every_step.h"

#include <cstddef>

namespace touchstone {

World EveryStep(const World& world) {
  World every = world;
  every.sample_every = 1;
  return every;
}

Trajectory SampledAs(const World& world, const Trajectory& of_steps) {
  Trajectory sampled{.status = of_steps.status,
                     .reason = of_steps.reason,
                     .times = {},
                     .samples = {},
                     .impulses = of_steps.impulses,
                     .gives_impulses = of_steps.gives_impulses,
                     .diverged_at_step = of_steps.diverged_at_step,
                     .complaint = of_steps.complaint,
                     .seconds = of_steps.seconds};
  const auto every = static_cast<std::size_t>(world.sample_every);
  for (std::size_t s = 0; s < of_steps.samples.size(); s += every) {
    sampled.times.push_back(of_steps.times[s]);
    sampled.samples.push_back(of_steps.samples[s]);
  }
  return sampled;
}

}  // namespace touchstone
