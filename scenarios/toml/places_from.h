#pragma once

#include <string_view>

#include "scenarios/file_places.h"
#include "scenarios/toml/parser.h"

namespace touchstone {

/** Returns where the expectations, the claims and the indictments of `file` stand. */
FilePlaces PlacesFrom(const toml::table& file, std::string_view file_name);

}  // namespace touchstone
