#pragma once

#include <array>

#include "oracles/trajectory.h"

namespace touchstone {

/** Returns the state after `t` [s] of a flight under gravity `g_W` whose velocity decays
 as exp(−c t): v̇ = g − c v. With s = (1 − exp(−c t))/c, v = v₀ + s (g − c v₀) and x = x₀ +
 v₀ t + (g − c v₀) (t − s)/c. [m], [m/s] */
PointState DampedFlight(const PointState& start, const Eigen::Vector3d& g_W, double c,
                        double t);

/** A first-order scheme for a damped flight. All agree in the limit of short steps. */
struct FlightScheme {
  bool damps_first;  ///< Velocity is damped before gravity is added to it.
  bool moves_first;  ///< Position moves by the velocity at the start of the step.
  bool linear;       ///< Velocity is multiplied by 1 − c h, else by exp(−c h).
};

/** Returns every such scheme. */
std::array<FlightScheme, 8> FlightSchemes();

/** Advances `state` by one step of `h` [s]. */
void StepFlight(const FlightScheme& scheme, const Eigen::Vector3d& g_W, double c,
                double h, PointState& state);

}  // namespace touchstone
