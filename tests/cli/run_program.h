#pragma once

#include <string>

namespace touchstone {

/** What a program left behind. */
struct Ended {
  int code;         ///< Exit code, or -1 where a signal ended it.
  std::string out;  ///< Standard output; on a terminal both outputs.
  std::string err;
};

/** Runs a shell command as a user in a pipe does. */
Ended InPipe(const std::string& command);

/** Whether this system gives pseudo-terminals; a bare root file system has none. */
bool CanOpenTerminals();

/** Runs a shell command as a user at a terminal does.
 @pre CanOpenTerminals() */
Ended OnTerminal(const std::string& command);

}  // namespace touchstone
