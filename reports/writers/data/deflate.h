#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace touchstone {

/** Returns `bytes` in the zlib format (RFC 1950), which browsers call "deflate". */
std::string Deflated(std::string_view bytes);

/** Returns the inflated bytes; empty if `bytes` is no whole zlib stream, is followed by
 anything, or inflates to more than `most` bytes. No more than that is ever held. */
std::optional<std::string> Inflated(std::string_view bytes, std::size_t most);

}  // namespace touchstone
