#pragma once

#include "scenarios/schema/scenario_keys.h"
#include "scenarios/toml/file_log.h"

namespace touchstone {

/** Logs missing keys, unknown keys and values of the wrong type in `file`. FaultsOf()
 checks whether a number of the right type is valid. */
void CheckStructure(const toml::table& file, TableKind kind, FileLog& log);

}  // namespace touchstone
