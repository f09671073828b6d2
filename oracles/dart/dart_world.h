#pragma once

#include <memory>
#include <span>

#include "oracles/oracle.h"
#include "oracles/simulation.h"

namespace touchstone {

/** Returns a simulation of `world` by DART, with `values` for the parameters that
 DescribeDartWorlds() declares.
 @pre DART can simulate it (DescribeDartWorlds) and has surfaces for it
 (dart_surfaces.h). */
std::unique_ptr<Simulation> DartWorld(const World& world, std::span<const double> values);

/** Adds DART's capabilities for worlds, and the settings and parameters used in them, to
 `info`. */
void DescribeDartWorlds(OracleInfo& info);

}  // namespace touchstone
