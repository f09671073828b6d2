#pragma once

#include <string>
#include <vector>

#include "scenarios/generators/random.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** The source of a random world. Worlds are built with z up and the ground at z = 0. */
struct WorldDraw {
  Random& random;
  double dt;              ///< The step of the world. [s]
  int ratio_decades = 1;  ///< Masses differ by a factor of up to 10 to this power.

  /** Returns 1 to 10^ratio_decades, all decades alike. */
  double Ratio() { return random.Decades(0, ratio_decades); }

  /** Returns a number in [0, 1], each of the ends in one case of five. */
  double Coefficient();

  /** Returns the half extents of a box, 0.05 to 0.4 m each. */
  Eigen::Vector3d HalfExtents();
};

/** The magnitude of gravity. [m/s²] */
inline constexpr double kGravity = 9.82;

/** Returns a world of `duration` [s], at least one step, with gravity along −z. */
WorldScenario EmptyWorld(const WorldDraw& draw, const std::string& title,
                         double duration);

/** Adds a body at rest. `named` and `mass` are its name and mass [kg]. Returns it; the
 reference ends with the next addition. */
RigidBody& AddBody(WorldScenario& scenario, const std::string& named, const Shape& shape,
                   double mass, const Pose& X_WB);

/** Adds the static ground z <= 0 of name "ground": a half-space, or in half of all worlds
 a box that is `reach` [m] wide to every side. */
void AddGround(WorldScenario& scenario, WorldDraw& draw, double reach);

/** Returns a place whose distance from `near_W` is about `distance` and where a ball of
 `radius` is at least 2 cm from the bounding spheres of all bodies: random places, each
 farther away than the last. [m] */
Eigen::Vector3d FreePlace(const World& world, const Eigen::Vector3d& near_W,
                          double distance, double radius, Random& random);

/** Gives every body that restitution and that friction. */
void SetContacts(WorldScenario& scenario, double restitution, double friction);

void AddClaim(WorldScenario& scenario, const std::string& law,
              const std::vector<std::string>& about, const std::string& because);

/** Returns an orientation that is turned about z by any angle. */
Eigen::Quaterniond TurnedAboutZ(Random& random);

/** Rotates everything in the world, gravity too. @pre There are no springs, cloths,
 pushes and forces. */
void Turn(const Eigen::Quaterniond& q_W, World& world);

}  // namespace touchstone
