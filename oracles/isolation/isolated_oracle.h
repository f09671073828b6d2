#pragma once

#include <chrono>
#include <cstddef>
#include <memory>

#include "oracles/oracle.h"

namespace touchstone {

/** The part of an oracle that runs in a child process. */
enum class IsolationScope {
  kEverything,
  kWorlds,  ///< Worlds only: an engine whose contact queries are known to be safe.
};

/** How much an isolated oracle may use for one question. */
struct IsolationLimits {
  /** CPU time rather than wall-clock time, so that a busy machine changes no result.
   Engines that answer at all do so within half a second: most in microseconds, FCL's EPA
   on round shapes takes longest. Engines that do not were still working after 20 s. The
   limit is four times the longest answer, so that a slow machine draws the same line.
   Four questions of the catalogue use all of it. */
  std::chrono::milliseconds cpu{2'000};
  /** Wall-clock time, for an engine that waits without working. Long enough for `cpu` on
   a machine shared with a hundred other processes. */
  std::chrono::milliseconds wall{60'000};
  /** CPU time and wall-clock time for one world, from start to end. */
  std::chrono::milliseconds world_cpu{60'000};
  std::chrono::milliseconds world_wall{3'600'000};
  /** Address space beyond that in use at the fork. Not enforced under
   AddressSanitizer and ThreadSanitizer, which reserve terabytes. [bytes] */
  std::size_t memory = std::size_t{4} << 30;
};

/** Returns an oracle that answers as `oracle` does, but in a child process. An engine
 that aborts, crashes, hangs, exits or exhausts the memory then loses one question instead
 of the run. The answer if the child

 - aborts: kCrashed, "aborted: <the last line of its stderr>";
 - is killed by a signal: kCrashed, "killed by SIGSEGV";
 - throws: kCrashed, "threw std::logic_error: …";
 - exits: kCrashed, "exited with status 3";
 - sends invalid bytes: kCrashed, "sent bytes that are not an answer";
 - uses up limits.cpu: kTimedOut, "no answer after 2 s of CPU time";
 - waits for limits.wall: kTimedOut, "no answer after 60 s, blocked".

 One child answers a whole batch of contact questions and records its answers in a file in
 memory, which is read when it has ended; one of worlds sends each trajectory. After a
 death, a new child continues with the next question. The cost is one fork per batch and
 some microseconds per question. Other output of the child is discarded. No child outlives
 the call, or the process if that is killed.

 Fork without exec is safe in a multithreaded process only as far as glibc makes it so:
 fork() takes the locks of malloc and stdio and restores them in the child. Any other lock
 that another thread holds at that moment stays locked in the child. Therefore `oracle`
 must take no lock while it answers, except its own, and must build its lazily initialised
 tables when it is constructed.

 A world is also one question, and SimulateEach() one batch. The last line that the child
 prints to its standard error on a world becomes Trajectory::complaint.

 An oracle that SetUp() returns is isolated with the same limits. Prepare(), Begin(),
 BeginWith(), BeginAsShipped() and BeginInThreads() call the inner oracle in this
 process: the questions of a benchmark are benign. Linux only. Thread safe. */
std::unique_ptr<Oracle> Isolate(std::unique_ptr<Oracle> oracle,
                                const IsolationLimits& limits = {},
                                IsolationScope scope = IsolationScope::kEverything);

}  // namespace touchstone
