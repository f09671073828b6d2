#pragma once

#include <optional>
#include <span>

#include "reports/worlds/truth/net.h"

namespace touchstone {

/** Returns the minimum of the energy in whose hollow the points of `net` are after
 `duration` [s], from `points_W` and `velocities_W`, with drag[i] [1/s] the rate at which
 point i slows.

 By the classical scheme of Runge and Kutta, a quarter of the shortest swing's radian a
 step. Nothing where half that step leads to another hollow, so that which one is not
 known, or where there are more steps than can be waited for. */
std::optional<Net::Points> RestAfter(const Net& net, std::span<const double> drag,
                                     const Net::Points& points_W,
                                     const Net::Points& velocities_W, double duration);

}  // namespace touchstone
