#pragma once

#include <string>
#include <string_view>

#include "oracles/oracle.h"
#include "reports/reproduce/engine_code.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Each function below returns the code that sets up `world` in the engine as the oracle
 does, and simulates it. EngineCode::ask is the body of

     std::map<int, WorldState> Simulate(const std::set<int>& wanted);

 which returns the states after those numbers of steps. It uses the table of BodiesText().
 They throw CannotReproduce. @pre The oracle simulates the world. */
EngineCode BulletWorldCode(const World& world, const OracleInfo& oracle);
EngineCode DartWorldCode(const World& world, const OracleInfo& oracle);
EngineCode MujocoWorldCode(const World& world, const OracleInfo& oracle);
EngineCode OdeWorldCode(const World& world, const OracleInfo& oracle);

/** Returns the code of the engine of `oracle`. Throws CannotReproduce if it is none of
 the four, or if the world has anything but rigid bodies that only constant forces act on.
 */
EngineCode WorldCodeOf(const World& world, const OracleInfo& oracle);

/** Returns definitions at namespace scope: the types of a program for a world, and the
 table of its bodies, kBodies. */
std::string BodiesText(const World& world);

/** The statements of Simulate() that depend on the engine. Body `i` is that of the table.
 */
struct SimulationText {
  std::string set_up;    ///< Creates the world as it starts.
  std::string step;      ///< Advances it by kStep.
  std::string read;      ///< Sets state[i] to the state of body i, which moves.
  std::string clean_up;  ///< May be empty.
};

/** Returns the body of Simulate(). */
std::string SimulateText(const SimulationText& text);

/** Returns the value of the parameter `name` that is in force in worlds of `oracle`.
 @pre It has that parameter. */
double ValueOf(const OracleInfo& oracle, std::string_view name);

/** Returns `statement` as a line of the program after a comment that explains the
 parameter `name`: its meaning, its default in the engine and the reason to change it. */
std::string Explained(const OracleInfo& oracle, std::string_view name,
                      std::string_view statement);

/** The same, but nothing if the parameter has its default in the engine. */
std::string IfChanged(const OracleInfo& oracle, std::string_view name,
                      std::string_view statement);

}  // namespace touchstone
