#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

#include "oracles/isolation/message_socket.h"

namespace touchstone {

/** The resources that a child process may use. */
struct ChildLimits {
  std::chrono::milliseconds cpu;   ///< CPU time of all its threads for one task.
  std::chrono::milliseconds wall;  ///< Longest wait of the parent for one message.
  /** Address space beyond that in use at the fork. Not limited if
   `kSanitizerReservesMemory`. [bytes] */
  std::size_t memory;
  std::size_t message;  ///< Longest valid message. [bytes]
};

/** The process as seen from inside the child: its messages to and from the parent, its
 limits and its output. */
class ChildContext {
 public:
  /** Confines the calling process, a child just forked. Signals get their default
   actions, every descriptor except stdin and these three is closed, stdout is discarded,
   stderr goes to `output`, and the limits apply.
   @param socket The child's end of the socket.
   @param output A file.
   @param records A file for Record(). */
  ChildContext(int socket, int output, int records, const ChildLimits& limits);

  /** Starts a task: discards what was printed so far, and restarts the CPU time. */
  void StartTask();

  /** Sends a message. Ends the process if the parent has closed the socket. */
  void Send(std::string_view message);

  /** Appends a message to the records, which the parent reads after the end of this
   process. Unlike Send(), it wakes nobody. Ends the process if the file cannot grow. */
  void Record(std::string_view message);

  /** Returns the size of all records, at most that of the longest output. [bytes] */
  std::size_t recorded() const { return recorded_; }

  /** Waits for the next message, and returns its bytes, valid until the next call. Ends
   the process if the parent has closed the socket. */
  std::string_view Receive();

  /** Returns the last line printed to the standard error in this task; empty if there is
   none. To be called in a child. */
  static std::string LastLine();

 private:
  ChildLimits limits_;
  MessageSocket socket_;
  std::size_t recorded_ = 0;
};

}  // namespace touchstone
