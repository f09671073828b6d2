#pragma once

#include <string>
#include <string_view>

namespace touchstone {

/** Returns `text` as a comment: broken at spaces into lines of at most 90 characters
 where words permit, each started by `mark`, e.g. "# ", and ended by a newline. */
std::string Commented(std::string_view text, std::string_view mark);

}  // namespace touchstone
