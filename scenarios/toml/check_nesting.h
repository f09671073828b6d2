#pragma once

#include <string_view>

#include "scenarios/toml/file_log.h"

namespace touchstone {

/** Reports the first key with more than kMostKeyLevels levels in a TOML text, and returns
 whether there is none. The parser builds a table for each level, and everything that
 walks the tables recurses: so this is checked before the text is parsed. Strings and
 comments are skipped. The text need not be valid TOML. */
bool CheckNesting(std::string_view text, FileLog& log);

}  // namespace touchstone
