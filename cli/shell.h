#pragma once

#include <string>

namespace touchstone {

/** The standard output of a shell command, and its exit code. */
struct CommandResult {
  std::string text;
  int code = 0;  ///< Exit code; 127 if there is no shell, 128 + signal after a signal.
};

/** Runs a command in a POSIX shell, and waits for it. */
CommandResult RunInShell(const std::string& command);

/** Returns whether the shell finds a program of that name. */
bool IsInstalled(const std::string& program);

}  // namespace touchstone
