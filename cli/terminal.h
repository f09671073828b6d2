#pragma once

namespace touchstone {

/** What the program may do to its outputs. */
struct Terminal {
  bool colours;   ///< On standard output.
  bool progress;  ///< A progress bar on standard error.
};

/** Returns what the outputs of this process are: colours and progress only where they are
 terminals; no colours where NO_COLOR is set and not empty (no-color.org), or TERM is
 "dumb". */
Terminal DetectTerminal();

}  // namespace touchstone
