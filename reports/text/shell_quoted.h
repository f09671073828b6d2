#pragma once

#include <string>

namespace touchstone {

/** Returns `word` quoted for a POSIX shell. */
std::string ShellQuoted(const std::string& word);

}  // namespace touchstone
