#pragma once

#include <string>
#include <string_view>

namespace touchstone {

/** Returns the last line of `text` that is not empty, without control characters; a
 failed assertion is shortened to its place and its condition. */
std::string LastLineIn(std::string_view text);

/** Returns the last line of the file `fd` that is not empty, without control characters.
 A failed assertion is shortened to its place and its condition, a long line to its last
 4096 bytes. Empty if the file is empty or cannot be read. */
std::string LastLineOf(int fd);

}  // namespace touchstone
