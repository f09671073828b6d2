#pragma once

#include <string>

namespace touchstone {

/** Returns the JSON Schema (draft 7) of scenario files, for editors to complete and check
 them with. Made from the keys the reader reads by (scenarios/schema/scenario_keys.h); it
 cannot say all that the reader checks, such as units of vectors and dangling names. */
std::string ScenarioSchema();

}  // namespace touchstone
