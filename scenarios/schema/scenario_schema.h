#pragma once

#include <span>
#include <string>
#include <string_view>

namespace touchstone {

/** A name that a claim of a world may have, for completion in editors. */
struct ClaimName {
  std::string_view name;           ///< E.g. "ballistic".
  std::string_view documentation;  ///< One line.
};

/** Returns the JSON Schema (draft 7) of scenario files, for completion and checking in
 editors, with `claims` as the names of laws. It is generated from the same keys as the
 reader (scenarios/schema/scenario_keys.h). It cannot express every check of the reader,
 e.g. unit vectors and dangling names.

 A choice of tables is an `if` on the key that decides, never a `oneOf`: an editor then
 underlines the key that is wrong, and not the whole file for which no choice fits. */
std::string ScenarioSchema(std::span<const ClaimName> claims);

}  // namespace touchstone
