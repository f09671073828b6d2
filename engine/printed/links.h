#pragma once

#include <span>

#include "engine/printed/world.h"

namespace cookbook::printed {

/** The objects that an end of a spring or a joint may be attached to. */
struct Things {
  std::span<Body> bodies;
  std::span<Particle> particles;
};

/** Applies a spring's force over a step to the velocities of its ends. Under E-18 the
 force itself is the impulse, whatever the step. */
void Pull(const Spring& spring, const Things& things, double dt, const Errata& errata);

/** Moves the ends of a joint to their distance, in proportion to inverse mass, and
 removes their relative velocity along it. Under E-22 each end moves by half of the error,
 and no velocity is removed. */
void Satisfy(const DistanceJoint& joint, const Things& things, const Errata& errata);

}  // namespace cookbook::printed
