#pragma once

#include <string>

namespace touchstone {

/** Returns the JSON Schema (draft 7) of scenario files, for completion and checking in
 editors. It is generated from the same keys as the reader
 (scenarios/schema/scenario_keys.h). It cannot express every check of the reader, e.g.
 unit vectors and dangling names. */
std::string ScenarioSchema();

}  // namespace touchstone
