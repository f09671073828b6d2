#pragma once

#include "scenarios/contact_query.h"
#include "scenarios/toml/parser.h"

namespace touchstone {

/** Returns the shape and the pose in the table of a body. Where CheckStructure() reports
 an error, a harmless default is used. */
Body BodyFrom(const toml::table& body);

}  // namespace touchstone
