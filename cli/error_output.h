#pragma once

#include <string>

namespace touchstone {

/** The standard error output of a child process, kept in a memory file. */
class ErrorOutput {
 public:
  /** @throws InputError if the system cannot create the file. */
  ErrorOutput();
  ~ErrorOutput();
  ErrorOutput(const ErrorOutput&) = delete;
  ErrorOutput& operator=(const ErrorOutput&) = delete;

  /** Redirects the standard error of the calling process to this file, up to 64 MiB. Call
   it in the child. */
  void Take() const;

  /** Returns the last line printed so far, see LastLineOf(). */
  std::string LastLine() const;

 private:
  int file_ = -1;  ///< Descriptor of an anonymous file.
};

}  // namespace touchstone
