#pragma once

#include <string>

namespace touchstone {

/** An error in a file: its position, what is wrong, and what was expected instead. */
struct Diagnostic {
  std::string file;
  int line = 0;    ///< Counted from 1; 0: the error concerns the whole file.
  int column = 0;  ///< Counted from 1, in code points.
  std::string what;
  std::string expected;
};

/** Returns "file:line:column: what; expected what"; without a line, "file: what; …". */
std::string ToString(const Diagnostic& diagnostic);

/** Returns a diagnostic that is not an error: "file:line:column: note: what". */
std::string ToNote(const Diagnostic& note);

}  // namespace touchstone
