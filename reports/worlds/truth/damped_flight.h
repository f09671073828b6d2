#pragma once

#include <array>

#include "oracles/trajectory.h"

namespace touchstone {

/** Returns the flight after `t` [s] under gravity `g_W`, where velocity decays as exp(−c
 t): v̇ = g − c v, so that with s = (1 − exp(−c t))/c v = v₀ + s (g − c v₀),  x = x₀ + v₀ t
 + (g − c v₀) (t − s)/c. [m], [m/s] */
PointState DampedFlight(const PointState& start, const Eigen::Vector3d& g_W, double c,
                        double t);

/** How an engine of first order steps a damped flight. All are the same in the limit of
 short steps. */
struct FlightScheme {
  bool damps_first;  ///< Velocity is damped before gravity adds to it.
  bool moves_first;  ///< Position moves by the velocity that the step starts with.
  bool linear;       ///< Velocity times 1 − c h, else times exp(−c h).
};

/** Returns every such scheme. */
std::array<FlightScheme, 8> FlightSchemes();

/** Advances `state` by one step of `h` [s]. */
void StepFlight(const FlightScheme& scheme, const Eigen::Vector3d& g_W, double c,
                double h, PointState& state);

}  // namespace touchstone
