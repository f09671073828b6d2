#pragma once

#include <string>
#include <string_view>

namespace touchstone {

/** Returns `bytes` in base64 (RFC 4648, section 4), padded, in one line. */
std::string Base64(std::string_view bytes);

}  // namespace touchstone
