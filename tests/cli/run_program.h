#pragma once

#include <string>

namespace touchstone {

/** The exit code and the output of a program. */
struct Ended {
  int code;         ///< Exit code, or -1 if a signal ended the program.
  std::string out;  ///< Standard output; on a terminal both outputs.
  std::string err;  ///< Standard error; empty on a terminal.
};

/** Runs a shell command with its output redirected. */
Ended InPipe(const std::string& command);

/** Returns whether this system provides pseudo-terminals. A bare root file system does
 not. */
bool CanOpenTerminals();

/** Runs a shell command on a pseudo-terminal.
 @pre CanOpenTerminals() */
Ended OnTerminal(const std::string& command);

}  // namespace touchstone
