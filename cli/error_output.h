#pragma once

#include <string>

namespace touchstone {

/** What a child process prints to its standard error, kept until somebody asks. */
class ErrorOutput {
 public:
  /** @throws InputError where the system gives no file. */
  ErrorOutput();
  ~ErrorOutput();
  ErrorOutput(const ErrorOutput&) = delete;
  ErrorOutput& operator=(const ErrorOutput&) = delete;

  /** In the child: from now on its standard error goes here, up to 64 MiB of it. */
  void Take() const;

  /** Returns the last line that has come so far, see LastLineOf(). */
  std::string LastLine() const;

 private:
  int file_ = -1;  ///< Without a name.
};

}  // namespace touchstone
