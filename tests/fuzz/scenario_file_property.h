#pragma once

#include <string>
#include <string_view>

namespace touchstone {

/** Reads `text` as a scenario file and returns what is wrong with the reader; empty where
 nothing is. Any text is either refused with a place in it, or read as a valid scenario
 that is written and read back bit for bit, to the same text. */
std::string FaultOfReading(std::string_view text);

}  // namespace touchstone
