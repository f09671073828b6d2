#pragma once

#include <cstddef>

#include "reports/worlds/law_support/on_plane.h"
#include "reports/worlds/law_support/worst.h"

namespace touchstone {

/** Returns whether friction at the sole tips a box that lies flat. Friction that
 decelerates or holds the box by `grip` [m/s²] moves the centre of support forward, at
 most to the edge. */
bool Tips(const RigidBody& box, const OnPlane& on, double grip);

/** Checks that a box that slides flat on a plane does not rotate.

 The normal forces λ_i on its sole, at r_i from the point below the centre, balance the
 moment of the friction f along f̂. So Σ λ_i r_i is along f̂, and the moment μ (Σ λ_i r_i) ×
 f̂ about the normal is zero, for any sole and heading.

 While the box settles, its corners move along the normal, by Settling() and at
 SettlingSpeed() at most. Friction follows the pressure, so it turns the box about the
 normal by μ times as much. Divided by the half width of the sole these are angles and
 spins, × 1.5. The solver leaves kSolverResidual of the speed. */
class FlatBox {
 public:
  /** `on` says how `world.bodies[body]` lies on its plane. @pre It is a box. */
  FlatBox(const Motion& motion, int body, const OnPlane& on);

  /** Checks sample `s`, up to which friction and gravity may have changed the velocity by
   `speed` [m/s]. */
  void Take(std::size_t s, double speed);

  const Worst& orientation() const { return orientation_; }
  const Worst& spin() const { return spin_; }

 private:
  const Motion& motion_;
  int body_;
  double settling_angle_;  ///< [rad]
  double settling_spin_;   ///< [rad/s]
  double half_width_;      ///< Smaller half width of the sole. [m]
  Worst orientation_;
  Worst spin_;
};

}  // namespace touchstone
