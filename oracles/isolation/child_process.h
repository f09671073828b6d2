#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <sys/types.h>

#include "oracles/contact_answer.h"
#include "oracles/isolation/child_context.h"
#include "oracles/isolation/living_child.h"
#include "oracles/isolation/message_socket.h"
#include "oracles/isolation/unique_fd.h"

namespace touchstone {

/** A forked child process that exchanges messages with this one. An engine in it that
 aborts, crashes, hangs or exhausts the memory ends the child only, and the reason is
 known. The child ends with this process. */
class ChildProcess {
 public:
  /** The work of the child. Never returns to the caller of the constructor. */
  using Main = std::function<void(ChildContext&)>;

  /** How the child ended, as the answer that it did not send. */
  struct Ending {
    AnswerStatus status;
    std::string reason;
  };

  /** Forks a child that calls `main` and exits with status 0.
   @throws std::system_error if the system provides no process, socket or file, or
   after EndChildren(). */
  ChildProcess(const ChildLimits& limits, const Main& main);

  /** Kills the child if it is still running, and waits for its end. */
  ~ChildProcess();

  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /** Sends a message, which is lost if the child has ended. */
  void Send(std::string_view message) { socket_.Send(message); }

  /** Waits for the next message of the child and decodes its bytes. Returns nothing if
   the child will send none, or none in time, or if `decode` returns nothing. */
  template <typename Message>
  std::optional<Message> Receive(std::optional<Message> (*decode)(std::string_view)) {
    const std::optional<std::string_view> bytes = ReceiveBytes();
    if (!bytes) return std::nullopt;
    std::optional<Message> message = decode(*bytes);
    if (!message) socket_.Reject();
    return message;
  }

  /** Returns the next record of the child, decoded. The first call waits until the child
   has ended, or has recorded nothing for the limit of wall-clock time. Returns nothing if
   there is no further record, or if `decode` returns nothing. */
  template <typename Message>
  std::optional<Message> NextRecord(std::optional<Message> (*decode)(std::string_view)) {
    const std::optional<std::string_view> bytes = NextRecordBytes();
    if (!bytes) return std::nullopt;
    std::optional<Message> message = decode(*bytes);
    if (!message) socket_.Reject();
    return message;
  }

  /** Returns the size of the records that NextRecord() has returned. [bytes] */
  std::size_t taken() const { return taken_; }

  /** Kills the child if it is still running, and returns how it ended.
   @pre Receive() or NextRecord() has returned nothing. */
  Ending End();

  /** Returns the last line that the child has printed to its standard error in its
   current task, see LastLineOf(). */
  std::string LastLine() const;

 private:
  std::optional<std::string_view> ReceiveBytes();
  std::optional<std::string_view> NextRecordBytes();
  void AwaitRecords();
  bool IsDead() const;
  int Kill();

  ChildLimits limits_;
  UniqueFd output_;                      // An unnamed file: the child's stderr.
  UniqueFd records_;                     // An unnamed file: what the child has recorded.
  std::optional<std::string> recorded_;  // Its contents, once they have been read.
  std::size_t taken_ = 0;  // Bytes of `recorded_` that NextRecord() has returned.
  MessageSocket socket_;
  pid_t pid_ = -1;                     // Negative once the child has been waited for.
  std::optional<LivingChild> living_;  // Until then.
  int status_ = 0;                     // Wait status of the child.
};

}  // namespace touchstone
