#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "oracles/oracle.h"
#include "oracles/protocol/answer_limits.h"
#include "oracles/protocol/command.h"

namespace touchstone {

/** How much an external oracle may use. Its clock includes the start of its language and
 the compilation of its kernels, so that the limits are above those of IsolationLimits. */
struct ExternalLimits {
  AnswerLimits hello{std::chrono::minutes(2), std::chrono::minutes(2), 1 << 20};
  /** For one contact question: the longest line is a hundred times that of any engine. */
  AnswerLimits contact{std::chrono::seconds(10), std::chrono::seconds(60), 1 << 18};
  /** The longest line, or what the samples of the world need if that is more. */
  AnswerLimits world{std::chrono::seconds(60), std::chrono::minutes(10), 1 << 26};
};

/** Returns an oracle that is a program of its own, which speaks the oracle protocol
 (docs/oracle_protocol.md). `name` is its name; if it is empty, the one that the program
 states. One program runs for each thread that asks at the same time. A question on which
 it fails costs that answer: the program is started again, and the next question is asked.
 The answer if the program

 - aborts, is killed or exits: kCrashed, "killed by SIGSEGV: <the last line of its
 stderr>";
 - sends anything but the answer: kCrashed, "answered with the id 3; expected 5, …";
 - answers one question of a batch wrongly formed: kCrashed, "answers[3].normal: …";
 - works for too long: kTimedOut, "no answer after 10 s of CPU time";
 - waits for too long: kTimedOut, "no answer after 60 s, blocked".

 Contact questions are sent in batches. If a program fails on one, its questions are asked
 again one by one, by which the one that is to blame shows itself. If each is then
 answered, the failure is that of the first; but a batch that took too long was only too
 large.

 It simulates whole motions only: Begin() and its kin return null. Thread safe.
 @throws std::runtime_error if the program does not start or does not describe itself. */
std::unique_ptr<Oracle> MakeExternalOracle(std::string name, const Command& command,
                                           const ExternalLimits& limits = {});

}  // namespace touchstone
