#pragma once

#include <memory>

#include "engine/printed/errata.h"
#include "oracles/oracle.h"
#include "oracles/simulation.h"

namespace touchstone {

/** Returns `world` at its start, simulated by the published recipes with the given
 errata.
 @throws std::exception if the recipes refuse the world.
 @pre Its features are among those of SetPrintedWorldCapabilities(). */
std::unique_ptr<Simulation> BeginPrinted(const World& world,
                                         const cookbook::printed::Errata& errata);

/** Sets the features of a world that the published recipes can simulate. */
void SetPrintedWorldCapabilities(OracleInfo& info);

}  // namespace touchstone
