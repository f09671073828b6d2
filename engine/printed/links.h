#pragma once

#include <span>

#include "engine/printed/world.h"

namespace cookbook::printed {

/** Everything that an end of a spring or a joint may be fixed to. */
struct Things {
  std::span<Body> bodies;
  std::span<Particle> particles;
};

/** Changes the velocities of a spring's ends by its force over a step; under E-18 by the
 force itself, whatever the step. */
void Pull(const Spring& spring, const Things& things, double dt, const Errata& errata);

/** Puts the ends of a joint at their distance, by inverse mass, and takes away the
 velocity along it; under E-22 half and half, and no velocity. */
void Satisfy(const DistanceJoint& joint, const Things& things, const Errata& errata);

}  // namespace cookbook::printed
