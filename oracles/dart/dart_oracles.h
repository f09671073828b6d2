#pragma once

#include <memory>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** Returns the oracle "dart". It answers contact queries with DART's own collision
 detector (dart_contacts.h) and simulates worlds (dart_world.h). */
std::vector<std::unique_ptr<Oracle>> DartOracles();

}  // namespace touchstone
