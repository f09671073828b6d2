#pragma once

#include <cstddef>

namespace touchstone {

/** The terminal features that the program may use. */
struct Terminal {
  bool colours;   ///< On standard output.
  bool progress;  ///< A progress bar on standard error.
  /** Characters of a line of standard output; 0 if it is no terminal, or unknown. */
  std::size_t width;
};

/** Returns the features of the outputs of this process. Colours and the progress bar need
 a terminal, and a TERM other than "dumb". Colours also need NO_COLOR to be unset or empty
 (no-color.org). */
Terminal DetectTerminal();

}  // namespace touchstone
