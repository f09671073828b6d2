#pragma once

#include <span>
#include <string>

namespace touchstone {

/** Returns the definitions, at namespace scope, of

     WorldState Start();
     double EnergyOf(const WorldState& state);

 the state of the program's table and the energy of `bodies`, indices of the world's: that
 of motion, gravity and constant forces. [J] */
std::string EnergyText(std::span<const int> bodies);

/** Returns the definition, at namespace scope, of the momentum of `bodies`, [N s]:

     Vector MomentumOf(const WorldState& state); */
std::string MomentumText(std::span<const int> bodies);

}  // namespace touchstone
