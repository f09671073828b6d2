#pragma once

#include "scenarios/scenario.h"
#include "scenarios/toml/file_log.h"

namespace touchstone {

/** Returns the contact query of a file, and logs values of the right type that cannot be.
 */
Scenario ContactFrom(const toml::table& file, FileLog& log);

}  // namespace touchstone
