#pragma once

#include <string_view>

#include "scenarios/file_places.h"
#include "scenarios/toml/parser.h"

namespace touchstone {

/** Returns the positions of the expectations, claims and indictments of `file`. */
FilePlaces PlacesFrom(const toml::table& file, std::string_view file_name);

}  // namespace touchstone
