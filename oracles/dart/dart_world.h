#pragma once

#include <memory>

#include "oracles/oracle.h"
#include "oracles/simulation.h"

namespace touchstone {

/** How contacts are stabilised. */
enum class DartContacts {
  kRigid,      ///< As rigid as DART can make them; overlap is not pushed out.
  kAsShipped,  ///< DART's defaults.
};

/** Returns `world` in the hands of DART.
 @pre DART can simulate it (DescribeDartWorlds) and has surfaces for it
 (dart_surfaces.h). */
std::unique_ptr<Simulation> DartWorld(const World& world, DartContacts contacts);

/** Adds to `info` what DART can do of worlds, and what is set in them. */
void DescribeDartWorlds(OracleInfo& info);

}  // namespace touchstone
