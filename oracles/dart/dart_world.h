#pragma once

#include <memory>

#include "oracles/oracle.h"
#include "oracles/simulation.h"

namespace touchstone {

/** The stabilisation of contacts. */
enum class DartContacts {
  kRigid,      ///< The most rigid that DART allows; overlap is not pushed out.
  kAsShipped,  ///< DART's defaults.
};

/** Returns a simulation of `world` by DART.
 @pre DART can simulate it (DescribeDartWorlds) and has surfaces for it
 (dart_surfaces.h). */
std::unique_ptr<Simulation> DartWorld(const World& world, DartContacts contacts);

/** Adds DART's capabilities for worlds, and the settings used in them, to `info`. */
void DescribeDartWorlds(OracleInfo& info);

}  // namespace touchstone
