#include <algorithm>
#include <string>
#include <vector>

#include "scenarios/generators/worlds/world_builders.h"

namespace touchstone {
namespace {

/** A level of a stack. */
struct Level {
  Eigen::Vector3d half;    ///< Half extents of its box. [m]
  double mass;             ///< [kg]
  Eigen::Vector2d centre;  ///< Its place on the ground. [m]

  /** Radius of the largest disc in its face. [m] */
  double Radius() const { return std::min(half.x(), half.y()); }
};

/** Shifts the levels so that all can rest, whatever way they are turned. Let c be the
 common centre of mass of all levels above some level. From the top down, the centre of
 that level is put 0.3 of a radius or less off c. The lowest level above was put as near
 to the centre of mass of the rest, and c lies between both, so c is within 0.3 of a
 radius of its centre, too. So c lies above the discs of both faces that meet, and above
 the part that they share. */
void Balance(Random& random, std::vector<Level>& levels) {
  Eigen::Vector2d centre_of_mass = Eigen::Vector2d::Zero();
  double mass = levels.back().mass;
  levels.back().centre = centre_of_mass;
  for (std::size_t k = levels.size() - 1; k-- > 0;) {
    Level& level = levels[k];
    const double radius = std::min(level.Radius(), levels[k + 1].Radius());
    const double shift = random.Uniform(0, 0.3) * radius;
    level.centre = centre_of_mass + shift * random.PlaneDirection();
    centre_of_mass =
        (mass * centre_of_mass + level.mass * level.centre) / (mass + level.mass);
    mass += level.mass;
  }
}

}  // namespace

WorldScenario Stack(WorldDraw& draw, int height) {
  Random& random = draw.random;
  WorldScenario scenario =
      EmptyWorld(draw, "A stack of " + std::to_string(height) + " boxes at rest",
                 random.Uniform(0.3, 0.7));
  AddGround(scenario, draw, 5);
  const double mass = random.Decades(-1, 1);
  std::vector<Level> levels;
  for (int k = 0; k < height; ++k) {
    const Eigen::Vector3d half = draw.HalfExtents();
    levels.push_back({half, mass * draw.Ratio(), Eigen::Vector2d::Zero()});
  }
  Balance(random, levels);
  const bool are_aligned = random.Coin();
  double top = 0;
  std::vector<std::string> names;
  for (const Level& level : levels) {
    names.push_back("box_" + std::to_string(names.size()));
    const Eigen::Quaterniond turned = TurnedAboutZ(random);
    AddBody(
        scenario, names.back(), Box{level.half}, level.mass,
        Pose::FromQuaternion({level.centre.x(), level.centre.y(), top + level.half.z()},
                             are_aligned ? Eigen::Quaterniond::Identity() : turned));
    top += 2 * level.half.z();
  }
  const bool bounces = random.Coin();
  const double restitution = random.Uniform();
  SetContacts(scenario, bounces ? restitution : 0, random.Uniform(0.3, 1));
  AddClaim(scenario, "rests", names, "each level lies on the one below");
  AddClaim(scenario, "stack_support", names, "each level lies on the one below");
  return scenario;
}

}  // namespace touchstone
