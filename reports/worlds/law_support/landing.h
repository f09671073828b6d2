#pragma once

#include <optional>
#include <vector>

#include "scenarios/validate.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** A static plane under a body: a half-space, or a wide enough face of a box. */
struct Landing {
  int ground = -1;       ///< Into World::bodies.
  Eigen::Vector3d n_W;   ///< Its outward unit normal.
  double gap = 0;        ///< Distance of the body's nearest point; < 0: penetrating. [m]
  Eigen::Vector3d p_WC;  ///< That nearest point, at the start. [m]
  double restitution = 0;  ///< min(e_A, e_B).
  double friction = 0;     ///< √(μ_A μ_B).
};

/** Returns the static plane that `body` faces at the start: the nearest one on whose
 outward side it is. Empty if there is none that collides with it. A box counts by the
 face whose plane the body's centre is farthest outside of, if the centre projects onto
 that face. */
std::optional<Landing> LandingOf(const World& world, int body);

/** Returns the same for a point at `p_W`, without restitution and friction. */
std::optional<Landing> LandingOfPoint(const World& world, const Eigen::Vector3d& p_W);

/** Returns whether `body` lands on a plane of normal `n_W` without being turned: it is a
 sphere, or a face or a side of it is parallel to the plane, below its centre of mass. A
 capsule on its end and a cone on its apex do not lie flat: they balance on a point, and
 an impact multiplies the tilt of a rounding by m l²/I, more at each bounce. */
bool LiesFlat(const RigidBody& body, const Eigen::Vector3d& n_W);

/** The arrival of a body at the plane that it faces. */
struct Arrival {
  double time;   ///< NaN if the body never arrives. [s]
  double speed;  ///< Speed into the plane. [m/s]
};

/** Returns the arrival of a body with the velocity `v_W` and the constant acceleration
 `a_W`. */
Arrival ArrivalAt(const Landing& landing, const Eigen::Vector3d& v_W,
                  const Eigen::Vector3d& a_W);

/** Returns the support point of `body` along `d_W` at the start, the farthest point of
 its shape. [m] @pre It is no half-space. */
Eigen::Vector3d SupportOf(const RigidBody& body, const Eigen::Vector3d& d_W);

}  // namespace touchstone
