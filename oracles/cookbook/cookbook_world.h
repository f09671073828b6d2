#pragma once

#include <memory>
#include <span>
#include <vector>

#include "oracles/oracle.h"
#include "oracles/simulation.h"

namespace touchstone {

/** How the worlds of the corrected engine are set up. */
enum class CookbookSetup {
  kAwake,  ///< Bodies never sleep.
  /** Bodies at rest sleep, and two threads share each step. It only steps worlds: the
   contact queries would be those of kAwake. */
  kSleeping,
};

/** Returns whether the corrected engine supports each feature of a world. */
decltype(OracleInfo::world_capabilities) CookbookWorldCapabilities();

/** Returns the settings of the corrected engine for worlds. */
std::vector<Setting> CookbookWorldSettings(CookbookSetup setup);

/** The settings of the corrected engine that may be chosen for worlds. Those of kAwake
 are its defaults. */
std::vector<WorldParameter> CookbookWorldParameters(CookbookSetup setup);

/** Returns the speed below which bodies fall asleep with `values` of these parameters; 0
 if they never sleep. [m/s] */
double CookbookSleepSpeed(std::span<const double> values);

/** Returns `world` at its start, in the corrected engine. `values` are those of
 CookbookWorldParameters(), in their order.
 @pre The world is valid and within CookbookWorldCapabilities(). */
std::unique_ptr<Simulation> BeginCookbookWorld(const World& world,
                                               std::span<const double> values);

/** The same with `threads` threads in place of the value of that parameter; the results
 are bitwise identical for any number. */
std::unique_ptr<Simulation> BeginCookbookWorldInThreads(const World& world, int threads,
                                                        std::span<const double> values);

}  // namespace touchstone
