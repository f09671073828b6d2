#pragma once

#include <string>
#include <string_view>

namespace touchstone {

/** Reads `text` as a table of contact questions and returns a fault of the reader; empty
 if there is none. The reader must either refuse the text with a position in it, or return
 valid questions, which must read back bit for bit after they are written. */
std::string FaultOfReadingTable(std::string_view text);

}  // namespace touchstone
