#pragma once

#include "scenarios/contact_query.h"
#include "scenarios/toml/parser.h"

namespace touchstone {

/** Returns the shape and the pose that the table of a body gives, harmless ones where
 CheckStructure() has something to say. */
Body BodyFrom(const toml::table& body);

}  // namespace touchstone
