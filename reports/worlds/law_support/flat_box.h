#pragma once

#include <functional>
#include <vector>

#include "reports/worlds/law_support/on_plane.h"
#include "reports/worlds/law_support/worst.h"

namespace touchstone {

/** Returns whether friction at the sole tips a box that lies flat. Friction that
 decelerates or holds the box by `grip` [m/s²] moves the centre of support forward, at
 most to the edge. */
bool Tips(const RigidBody& box, const OnPlane& on, double grip);

/** Judges that a box that slides flat on a plane does not rotate: orientation and spin.

 The normal forces λ_i on its sole, at r_i from the point below the centre, balance the
 moment of the friction f along f̂. So Σ λ_i r_i is along f̂, and the moment μ (Σ λ_i r_i) ×
 f̂ about the normal is zero, for any sole and heading.

 While the box settles, its corners move along the normal, by Settling() and at
 SettlingSpeed() at most. Friction follows the pressure, so it turns the box about the
 normal by μ times as much. Divided by the half width of the sole these are angles and
 spins, × 1.5. The solver leaves 1e-5 of the speed over that half width.

 `on` says how `world.bodies[body]` lies on its plane; `speed(t)` is what friction and
 gravity may have changed of its velocity until `t` [s]. [m/s] @pre It is a box. */
std::vector<Worst> JudgeFlatBox(const Motion& motion, int body, const OnPlane& on,
                                const std::function<double(double t)>& speed);

}  // namespace touchstone
