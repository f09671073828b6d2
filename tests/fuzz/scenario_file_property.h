#pragma once

#include <string>
#include <string_view>

namespace touchstone {

/** Reads `text` as a scenario file and returns a fault of the reader; empty if there is
 none. The reader must either refuse the text with a position in it, or return a valid
 scenario. A scenario must read back bit for bit after writing, and then be written as the
 same text. */
std::string FaultOfReading(std::string_view text);

}  // namespace touchstone
