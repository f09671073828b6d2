#pragma once

#include <string>

#include "oracles/oracle.h"

namespace touchstone {

/** Returns `because`, the origin of a tolerance that grants the documented slop of
 `oracle` too, with that slop and its source. Returns it unchanged without a slop. */
std::string WithSlop(std::string because, const OracleInfo& oracle);

}  // namespace touchstone
