#pragma once

#include <chrono>
#include <cstddef>
#include <memory>

#include "oracles/oracle.h"

namespace touchstone {

/** What of an oracle runs in a child process. */
enum class IsolationScope {
  kEverything,
  kWorlds,  ///< Worlds only: an engine whose contact queries are known to be safe.
};

/** How much an isolated oracle may take for one question. */
struct IsolationLimits {
  /** CPU time, so that a busy machine changes no result. What answers at all does so
   within half a second (most in microseconds; FCL's EPA on round shapes takes longest),
   and what does not was still at work after 20 s: the limit is four times the longest, so
   that a slow machine draws the same line. Of four questions of the catalogue, this is
   what they take. */
  std::chrono::milliseconds cpu{2'000};
  /** Wall clock, for an engine that waits without working. Long enough for `cpu` on a
   machine shared by a hundred others. */
  std::chrono::milliseconds wall{60'000};
  /** CPU time and wall clock for one world, from its start to its end. */
  std::chrono::milliseconds world_cpu{60'000};
  std::chrono::milliseconds world_wall{3'600'000};
  /** Address space beyond what the process has already; not enforced under
   AddressSanitizer and ThreadSanitizer, which reserve terabytes. [bytes] */
  std::size_t memory = std::size_t{4} << 30;
};

/** Returns an oracle that answers as `oracle` does, but in a child process, so that an
 engine that aborts, crashes, hangs, exits or eats the memory loses one question and not
 the run. The answer where the child

 - aborts: kCrashed, "aborted: <the last line of its stderr>";
 - dies of a signal: kCrashed, "died of SIGSEGV";
 - throws: kCrashed, "threw std::logic_error: …";
 - exits: kCrashed, "exited with status 3";
 - sends what is no answer: kCrashed, "sent bytes that are no answer";
 - uses up limits.cpu: kTimedOut, "no answer after 2 s of CPU time";
 - waits for limits.wall: kTimedOut, "no answer after 60 s, blocked".

 One child answers a whole batch, streaming; after a death a new one goes on with the next
 question. Costs one fork a batch and some microseconds a question. What the child prints
 is not shown. No child outlives the call, nor the process if that is killed.

 Fork without exec is safe in a multithreaded process as far as glibc makes it so: fork()
 takes and remakes the locks of malloc and stdio. A lock of anything else, held by another
 thread at that moment, stays locked in the child: so `oracle` must take none while it
 answers but those it takes for itself, and must have its lazily made tables made when it
 is constructed.

 A world is one question as well, and SimulateEach() one batch: what the child prints to
 its standard error on a world becomes Trajectory::complaint.

 Prepare(), Begin() and its kin give those of the inner oracle, in process: what a
 benchmark times is benign. Linux only. Thread safe. */
std::unique_ptr<Oracle> Isolate(std::unique_ptr<Oracle> oracle,
                                const IsolationLimits& limits = {},
                                IsolationScope scope = IsolationScope::kEverything);

}  // namespace touchstone
