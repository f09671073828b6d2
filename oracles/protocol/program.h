#pragma once

#include <csignal>
#include <optional>
#include <string>
#include <utility>

#include "oracles/contact_answer.h"
#include "oracles/isolation/living_child.h"
#include "oracles/protocol/answer_limits.h"
#include "oracles/protocol/message.h"
#include "oracles/protocol/start_program.h"

namespace touchstone {

/** Why a program gave no answer, as that of the question that it was working on. */
struct NoReply {
  AnswerStatus status;
  std::string reason;
};

/** A program that answers messages on its standard input with messages on its standard
 output (docs/oracle_protocol.md). It ends with this object, at the latest. */
class Program {
 public:
  /** @throws std::system_error as Start() does. */
  explicit Program(const Command& command)
      : started_(Start(command)), living_(std::in_place, -started_.pid) {}

  /** Tells the program to end, waits for a moment, then kills its process group. */
  ~Program();

  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /** Sends `message` with the next id, and returns the answer. Throws NoReply if the
   program ends, takes too long, or sends anything but a message with that id; it cannot
   be asked again then. */
  Message Ask(Message message, const AnswerLimits& limits);

  /** Returns the last line that it has printed to its standard error since the last
   Ask() began; empty if there is none. */
  std::string LastLine() const;

 private:
  class Exchange;

  void ReadMessages();
  std::optional<siginfo_t> AwaitEnd() const;
  NoReply Ended();

  StartedProgram started_;
  std::optional<LivingChild> living_;  // Until it has been waited for.
  std::string received_;  // From its standard output, not yet part of an answer.
  std::string tail_;      // The end of its standard error since the last Ask() began.
  int next_id_ = 0;
  bool failed_ = false;  // It has given no answer, and is not asked again.
};

}  // namespace touchstone
