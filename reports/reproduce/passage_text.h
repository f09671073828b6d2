#pragma once

#include <string>

#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns whether a program can compute how a straight way of body `A` leads through
 body `B`: A is a sphere, and B is a sphere or a box that does not move. */
bool HasPassage(const World& world, int A, int B);

/** Returns the least distance by which the sphere A must leave the straight line through
 its centres at the two states in order to pass B. Negative: the line passes B. For a box
 it is meaningful if the line meets the box. [m] @pre HasPassage() */
double PassageOf(const World& world, const WorldState& from, const WorldState& to, int A,
                 int B);

/** Returns the definition, at namespace scope, of the same as

     double Passage(const WorldState& from, const WorldState& to);

 @pre HasPassage() */
std::string PassageText(const World& world, int A, int B);

}  // namespace touchstone
