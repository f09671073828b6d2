#pragma once

#include <string>
#include <string_view>

namespace touchstone {

/** Reads `text` as a file of bounds and returns a fault of the reader; empty if there is
 none. The reader must either refuse the text with positions in it, or return bounds that
 are written as a text which reads back the same and is written the same again. */
std::string FaultOfReadingBounds(std::string_view text);

}  // namespace touchstone
