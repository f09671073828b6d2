#pragma once

#include <memory>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** Returns "dart", which answers by DART's own collision detector (dart_contacts.h) and
 simulates worlds (dart_world.h). */
std::vector<std::unique_ptr<Oracle>> DartOracles();

}  // namespace touchstone
