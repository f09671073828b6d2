#pragma once

#include <string_view>

namespace touchstone {

/** Returns whether `path`, levels joined by '/', matches `pattern`: '*' matches any
 characters within a level, '**' any characters across levels. */
bool MatchesGlob(std::string_view pattern, std::string_view path);

}  // namespace touchstone
