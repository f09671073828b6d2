#pragma once

#include <cstddef>

#include "reports/worlds/law_support/on_plane.h"
#include "reports/worlds/law_support/worst.h"

namespace touchstone {

/** Returns whether friction at the sole of a box that lies flat tips it: friction that
 slows or holds it by `grip` [m/s²] moves the support ahead, at most to the edge. */
bool Tips(const RigidBody& box, const OnPlane& on, double grip);

/** Holds a box that slides flat on a plane against not turning at all.

 What presses its sole, Σ λ_i at r_i from below the centre, balances the moment of the
 friction f along f̂: Σ λ_i r_i is along f̂, and so the moment μ (Σ λ_i r_i) × f̂ about the
 normal is zero, whatever the sole and the heading.

 While it settles, the corners move across the plane, by Settling() and at
 SettlingSpeed() at most; friction follows the pressure, so that what turns it about the
 normal is μ times that. Over the half width of the sole these are angles and spins,
 × 1.5; and the solver leaves kSolverResidual of the speed. */
class FlatBox {
 public:
  /** Where `on` is how `world.bodies[body]` lies on its plane. @pre It is a box. */
  FlatBox(const Motion& motion, int body, const OnPlane& on);

  /** Takes sample `s`, up to which friction and gravity may have changed the velocity by
   `speed` [m/s]. */
  void Take(std::size_t s, double speed);

  const Worst& orientation() const { return orientation_; }
  const Worst& spin() const { return spin_; }

 private:
  const Motion& motion_;
  int body_;
  double settling_angle_;  ///< [rad]
  double settling_spin_;   ///< [rad/s]
  double half_width_;      ///< Of the sole, the lesser. [m]
  Worst orientation_;
  Worst spin_;
};

}  // namespace touchstone
