#include "scenarios/generators/ensemble.h"

#include "scenarios/generators/random.h"

namespace touchstone {

World MemberOf(const WorldScenario& scenario, int index) {
  World world = scenario.world;
  if (index == 0) return world;
  const Ensemble& ensemble = *scenario.ensemble;
  Random random({ensemble.seed, static_cast<std::uint64_t>(index)});
  const auto move = [&](Eigen::Vector3d& p_W) {
    for (double& coordinate : p_W)
      coordinate += random.Uniform(-ensemble.jitter, ensemble.jitter);
  };
  for (RigidBody& body : world.bodies) {
    if (body.mass > 0) move(body.placed.X_WB.p_WB);
  }
  for (Particle& particle : world.particles) {
    if (particle.mass > 0) move(particle.p_W);
  }
  for (Cloth& cloth : world.cloths) move(cloth.centre);
  return world;
}

}  // namespace touchstone
