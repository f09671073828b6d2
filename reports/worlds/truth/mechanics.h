#pragma once

#include <vector>

#include "oracles/trajectory.h"
#include "reports/worlds/truth/subjects.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns the inertia tensor about the centre of mass, R I Rᵀ, in the world frame.
 [kg m²] */
Eigen::Matrix3d InertiaInWorld(const RigidBody& body, const Eigen::Quaterniond& q_WB);

/** Returns the acceleration of a body that only gravity and its force act on, g + F/m.
 [m/s²] */
Eigen::Vector3d AccelerationOf(const World& world, const RigidBody& body);

/** Returns the state that the world file specifies, from which every trajectory
 starts. */
WorldState StateAtStart(const World& world);

/** Returns the total mass of the subjects. [kg] */
double MassOf(const World& world, const Subjects& subjects);

/** Returns A² = Σ m |g + F/m|² over the subjects: with the kinetic energy E, their loads
 raise √(2 E) by at most A per second. [J/s²] */
double SquaredLoadsOf(const World& world, const Subjects& subjects);

/** The errors of momentum and of energy that follow from errors δv of the velocities. */
struct MotionOfNoise {
  double momentum = 0;  ///< Σ m δv. [N s]
  double energy = 0;    ///< Σ ½ m δv². [J]
  /** Σ m |x − c| δv about the centre c of mass. [N m s] */
  double angular_momentum = 0;
};

/** Returns the momenta and the energy of velocities δv = share |x|/h, with the step h of
 `world`. An engine that takes a velocity from positions, or corrects positions by
 velocities, cannot know it better than its positions. `share`: relative error of a
 position, the unit roundoff. [-] */
MotionOfNoise NoiseOfPositions(const World& world, const WorldState& state,
                               const Subjects& subjects, double share);

/** Returns the linear momentum Σ m v of the subjects. [N s] */
Eigen::Vector3d MomentumOf(const World& world, const WorldState& state,
                           const Subjects& subjects);

/** Returns Σ m |v| of the subjects: the magnitude of the terms of MomentumOf(). [N s] */
double MomentumSize(const World& world, const WorldState& state,
                    const Subjects& subjects);

/** Returns the centre of mass of the subjects. [m] */
Eigen::Vector3d CentreOf(const World& world, const WorldState& state,
                         const Subjects& subjects);

/** Returns the angular momentum Σ (x − c) × m v + R I Rᵀ ω of the subjects about the
 point `c_W`. [N m s] */
Eigen::Vector3d AngularMomentumOf(const World& world, const WorldState& state,
                                  const Subjects& subjects, const Eigen::Vector3d& c_W);

/** Returns Σ |x − c| m |v| + |R I Rᵀ ω|: the magnitude of the terms of
 AngularMomentumOf(). [N m s] */
double AngularMomentumSize(const World& world, const WorldState& state,
                           const Subjects& subjects, const Eigen::Vector3d& c_W);

/** Returns Σ |x − c| m |v| + I_max |ω|, the most that AngularMomentumOf() could be at
 these speeds. Roundings of the state change it in multiples of this: one of the
 orientation turns I, by the greatest moment even about the axis of the least. [N m s] */
double GreatestAngularMomentum(const World& world, const WorldState& state,
                               const Subjects& subjects, const Eigen::Vector3d& c_W);

/** The energy of some things, and its rate of conversion. */
struct Energy {
  double kinetic = 0;    ///< Σ ½ m v² + ½ ω·L. [J]
  double potential = 0;  ///< −Σ (m g + F)·x + Σ ½ k (|p_AB| − L)². [J]
  double power = 0;  ///< dU/dt, the rate at which kinetic becomes potential energy. [W]
  double size = 0;   ///< Sum of the absolute terms. [J]

  double total() const { return kinetic + potential; }
};

/** Returns the energy of the subjects, with the energies of the springs and cloths among
 them and of the springs that join them to anything else. */
Energy EnergyOf(const World& world, const WorldState& state, const Subjects& subjects);

/** Returns the position and velocity of an anchor. */
PointState StateOf(const World& world, const WorldState& state, const Anchor& anchor);

/** A spring between two nodes of one cloth. */
struct ClothSpring {
  int a = 0;  ///< Index of a node: row · n + column.
  int b = 0;
  double stiffness = 0;    ///< [N/m]
  double damping = 0;      ///< [N s/m]
  double rest_length = 0;  ///< [m]
};

/** Returns the springs of `cloth`; their rest lengths are the distances at the start. */
std::vector<ClothSpring> SpringsOf(const Cloth& cloth);

/** Returns the position of node (row, column) of `cloth` at the start. [m] */
Eigen::Vector3d NodeAtStart(const Cloth& cloth, int row, int column);

/** Returns whether node `node` of `cloth` is pinned. */
bool IsPinned(const Cloth& cloth, int node);

}  // namespace touchstone
