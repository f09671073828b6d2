#pragma once

#include <string>
#include <string_view>

namespace touchstone {

/** Returns what --help of `command` ends with: lines to try, and what the exit codes
 mean.
 @pre `command` is one of the program's. */
std::string ExamplesOf(std::string_view command);

}  // namespace touchstone
