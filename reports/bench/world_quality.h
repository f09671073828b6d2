#pragma once

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Quality of the state of a simulated world. Sent as plain bytes. */
struct WorldQuality {
  double deepest = 0;   ///< Deepest penetration of two bodies. [m]
  double fastest = 0;   ///< Largest speed of a body. [m/s]
  double sideways = 0;  ///< Largest horizontal displacement of a body; y is up. [m]
};

/** Returns the quality of `state`. Each number is NaN if it is NaN for any body. */
WorldQuality QualityOf(const World& world, const WorldState& state);

}  // namespace touchstone
