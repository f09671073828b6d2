#pragma once

#include <span>

#include "engine/printed/world.h"

namespace cookbook::printed {

/** Integrates a particle over a step: damping, then gravity, then the position. */
void Integrate(Particle& particle, const Eigen::Vector3d& gravity_W, double dt,
               const Errata& errata);

/** Keeps a particle out of static boxes. If the path of its last step enters one, puts it
 3 mm above that point along the surface normal and reflects its velocity: v_t − bounce
 v_n. */
void KeepOutside(Particle& particle, std::span<const Body> bodies);

}  // namespace cookbook::printed
