#pragma once

#include <string>
#include <string_view>

namespace touchstone {

/** Reads `bytes` as a line and a frame, and that as every message of the oracle protocol.
 Returns what is wrong with the readers: an exception other than ProtocolError, or a
 message that is not the same when it is written and read again. Empty if nothing is. */
std::string FaultOfReadingProtocol(std::string_view bytes);

}  // namespace touchstone
