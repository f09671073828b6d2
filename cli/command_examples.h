#pragma once

#include <string>
#include <string_view>

namespace touchstone {

/** Returns the paragraph of the --help text of `command` that follows its summary: what
 the command does.
 @pre `command` is one of the program's. */
std::string DescriptionOf(std::string_view command);

/** Returns the end of the --help text of `command`: example lines and the meaning of the
 exit codes.
 @pre `command` is one of the program's. */
std::string ExamplesOf(std::string_view command);

}  // namespace touchstone
