#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Families of worlds of a few bodies and of at most 2 s. Every world claims laws that
 its construction makes true of it. Unless the family says otherwise, the step is 1/60 to
 1/480 s and masses differ by up to 10. */
enum class WorldFamily {
  /** A box or a sphere falls onto the ground: straight, or tumbling at any attitude. */
  kDrops,
  /** One impact in flight: two spheres, a sphere on a plane, or an edge or a corner of a
   box on a plane, with restitution and friction from 0 to 1. */
  kImpacts,
  /** A box or a sphere on a plane: from rest on a slope with friction 10^-3 to 1 of the
   threshold away from it, on either side; sliding to a stop; slipping until it rolls;
   rolling along a slope. */
  kSlides,
  /** Pendulums, double pendulums, and bars that hang by rods. */
  kRods,
  /** Stacks of two to six boxes at rest, each turned and shifted. */
  kStacks,
  /** Two bodies whose masses differ by 1 to 10^4: in an impact, stacked, or on rods. */
  kMassRatios,
  /** Any of the above, or a free flight, with a step of 1/30 to 1/1000 s. */
  kStepLengths,
  /** Two to six spheres, boxes and bars of up to 1 : 20 on rods, thrown at the ground, at
   a wall and at each other. Masses differ by up to 100; the step is 1/30 to 1/1000 s. */
  kLinkages,
  /** Two to four boxes, bars and plates, thin ones down to 1 : 50, that fly at each other
   and past each other and turn by up to 1.5 rad in a step; the first may be fixed. Masses
   differ by up to 100; the step is 1/30 to 1/1000 s. */
  kBars,
};

/** Returns the families in the order of the enumeration. */
std::vector<WorldFamily> AllWorldFamilies();

/** Returns the name used on the command line and in reports: "drops", "impacts",
 "slides", "rods", "stacks", "mass_ratios", "step_lengths", "linkages", "bars". */
std::string_view NameOf(WorldFamily family);

/** Returns the family with that name; empty if there is none. */
std::optional<WorldFamily> WorldFamilyNamed(std::string_view name);

/** Returns world `index` of a family, with claims and a title, but without id and source.
 It is valid (scenarios/worlds/validate_world.h) and its claims have no errors. It is a
 pure function of the arguments, the same bit for bit on every machine with IEEE doubles.
 */
WorldScenario GenerateWorld(WorldFamily family, std::uint64_t seed, std::uint64_t index);

}  // namespace touchstone
