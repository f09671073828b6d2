#pragma once

#include <string>
#include <string_view>

namespace touchstone {

/** Returns `name` in quotation marks, “thrown”: users choose the names of bodies, and in
 a sentence any word may be one. */
std::string QuotedName(std::string_view name);

}  // namespace touchstone
