#pragma once

#include <optional>
#include <span>

#include "reports/worlds/truth/net.h"

namespace touchstone {

/** Returns the energy minimum whose basin contains the points of `net` after `duration`
 [s], from `points_W` and `velocities_W`; drag[i] [1/s] is the rate at which the velocity
 of point i decays.

 Integrated by the classical Runge-Kutta scheme in steps of a quarter radian of the
 fastest oscillation. Empty if half that step leads to another basin, so that the basin is
 uncertain, or if the number of steps is too large. */
std::optional<Net::Points> RestAfter(const Net& net, std::span<const double> drag,
                                     const Net::Points& points_W,
                                     const Net::Points& velocities_W, double duration);

}  // namespace touchstone
