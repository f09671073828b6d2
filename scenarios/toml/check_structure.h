#pragma once

#include "scenarios/schema/scenario_keys.h"
#include "scenarios/toml/file_log.h"

namespace touchstone {

/** Logs where `file` lacks keys that a file of its kind must have, has any that it may
 not, or values of another type. Whether a number of the right type is a good one is for
 FaultsOf() to say. */
void CheckStructure(const toml::table& file, TableKind kind, FileLog& log);

}  // namespace touchstone
