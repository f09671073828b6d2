#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scenarios/contact_query.h"
#include "scenarios/scenario.h"

namespace touchstone {

/** Returns the first lines of a scenario file: id, title and source. */
std::string HeadingLines(std::string_view id, std::string_view title,
                         std::string_view source);

/** Returns the lines of a body's table: its shape and its pose. */
std::string BodyLines(const Body& body);

/** Returns the tables of [[indicts]]. */
std::string IndictmentTables(const std::vector<Indictment>& indictments);

}  // namespace touchstone
