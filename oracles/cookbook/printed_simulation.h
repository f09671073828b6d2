#pragma once

#include <memory>

#include "engine/printed/errata.h"
#include "oracles/oracle.h"
#include "oracles/simulation.h"

namespace touchstone {

/** Returns `world` as the published recipes simulate it, with the given errata. Throws
 std::exception where the recipes refuse it. @pre Its features are among
 those of SetPrintedWorldCapabilities(). */
std::unique_ptr<Simulation> BeginPrinted(const World& world,
                                         const cookbook::printed::Errata& errata);

/** Sets what the published recipes can simulate. */
void SetPrintedWorldCapabilities(OracleInfo& info);

}  // namespace touchstone
