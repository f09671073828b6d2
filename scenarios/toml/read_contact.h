#pragma once

#include "scenarios/scenario.h"
#include "scenarios/toml/file_log.h"

namespace touchstone {

/** Returns the contact query of a file, and logs invalid values that have the right type.
 */
Scenario ContactFrom(const toml::table& file, FileLog& log);

}  // namespace touchstone
