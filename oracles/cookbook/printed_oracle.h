#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** Returns the recipes as published, by the name of a specimen, or null for any other
 name:

 - "printed": all errata, as they stand in print;
 - "printed:none": none, the recipes put right;
 - "printed:E-04": that erratum alone; "printed:E-01+E-02": those alone.

 A specimen says what its recipe computes and no more: nothing but the verdict of shapes
 apart, and one depth, the manifold's, for every contact. */
std::unique_ptr<Oracle> MakePrintedOracle(std::string_view name);

/** Returns the names of the specimens with all errata, none, and each one alone. */
std::vector<std::string> PrintedOracleNames();

}  // namespace touchstone
