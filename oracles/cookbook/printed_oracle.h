#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** Returns the specimen of the published recipes with this name, or null for any other
 name:

 - "printed": all errata, exactly as printed;
 - "printed:none": no errata, i.e. the corrected recipes;
 - "printed:E-04": only that erratum; "printed:E-01+E-02": only those.

 A specimen returns exactly what its recipe computes. For shapes apart this is only the
 verdict; for contacts it is one depth, that of the manifold. */
std::unique_ptr<Oracle> MakePrintedOracle(std::string_view name);

/** Returns the names of the specimens with all errata, with none, and with each alone. */
std::vector<std::string> PrintedOracleNames();

}  // namespace touchstone
