#pragma once

#include <string>

namespace touchstone {

/** One error of a file: where, what, and what was expected instead. */
struct Diagnostic {
  std::string file;
  int line = 1;    ///< From 1.
  int column = 1;  ///< From 1, in code points.
  std::string what;
  std::string expected;
};

/** Returns "file:line:column: what; expected what". */
std::string ToString(const Diagnostic& diagnostic);

}  // namespace touchstone
