#pragma once

#include <string>

namespace touchstone {

/** Returns the last line of the file `fd` that is not empty, without control characters.
 A failed assertion is shortened to its place and its condition, a long line to its last
 4096 bytes. Empty if the file is empty or cannot be read. */
std::string LastLineOf(int fd);

}  // namespace touchstone
