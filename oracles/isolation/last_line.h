#pragma once

#include <string>

namespace touchstone {

/** Returns the last line that is not empty of what was printed to the file `fd`, without
 control characters, and of a failed assertion only where and which; of a longer line its
 last 4096 bytes. Empty where nothing was printed, or the file cannot be read. */
std::string LastLineOf(int fd);

}  // namespace touchstone
