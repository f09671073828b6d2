#pragma once

#include "scenarios/contact_query.h"
#include "scenarios/toml/file_log.h"
#include "scenarios/toml/parser.h"

namespace touchstone {

/** Returns the shape and the pose in the table of a body. Where CheckStructure() reports
 an error, a harmless default is used. Adds a note to `log` for a quaternion that it
 normalises. */
Body BodyFrom(const toml::table& body, FileLog& log);

}  // namespace touchstone
