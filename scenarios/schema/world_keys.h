#pragma once

#include <span>

#include "scenarios/schema/scenario_keys.h"

namespace touchstone {

/** Returns the keys of a table of a world's file, in the order in which they are written;
 empty for any other table. */
std::span<const Key> KeysOfWorldTable(TableKind table);

}  // namespace touchstone
