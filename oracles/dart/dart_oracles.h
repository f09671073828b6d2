#pragma once

#include <memory>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** Returns "dart", which simulates worlds by DART (dart_world.h) and answers no contact
 queries. */
std::vector<std::unique_ptr<Oracle>> DartOracles();

}  // namespace touchstone
