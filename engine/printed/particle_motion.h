#pragma once

#include <span>

#include "engine/printed/world.h"

namespace cookbook::printed {

/** Integrates a particle over a step: its velocity decays and falls, then it moves. */
void Integrate(Particle& particle, const Eigen::Vector3d& gravity_W, double dt,
               const Errata& errata);

/** Where the way of the last step enters a static box, puts the particle 3 mm above that
 point along the surface normal and reflects its velocity: v_t − bounce v_n. */
void KeepOutside(Particle& particle, std::span<const Body> bodies);

}  // namespace cookbook::printed
