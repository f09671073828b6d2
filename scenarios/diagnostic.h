#pragma once

#include <string>

namespace touchstone {

/** One error of a file: where, what, and what was expected instead. */
struct Diagnostic {
  std::string file;
  int line = 0;    ///< From 1; 0: the error is of the file as a whole.
  int column = 0;  ///< From 1, in code points.
  std::string what;
  std::string expected;
};

/** Returns "file:line:column: what; expected what"; without a line, "file: what; …". */
std::string ToString(const Diagnostic& diagnostic);

}  // namespace touchstone
