#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "oracles/isolation/child_process.h"
#include "oracles/oracle.h"
#include "reports/bench/step_time.h"
#include "reports/bench/world_quality.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Settings for stepping an engine. */
struct Stepping {
  int threads = 1;                        ///< Number of threads that share a step.
  std::chrono::milliseconds cpu{60'000};  ///< CPU time of all threads, from the start on.
  std::chrono::milliseconds wall{3'600'000};  ///< Longest wait for one reply.
};

/** An engine that steps a world in its own process, on demand. Several engines can thus
 take turns, and an engine that crashes or takes hours for a step loses only its own
 results. */
class SteppingChild {
 public:
  /** Starts the child process.
   @pre `oracle` can simulate `world` with the requested number of threads.
   @throws std::system_error if the system cannot create the process. */
  SteppingChild(const Oracle& oracle, const World& world, const Stepping& stepping);

  /** Takes `steps` > 0 steps. Returns the average time of one; empty once the child has
   ended. */
  std::optional<StepTime> Step(int steps);

  /** Returns the quality of the current state; empty once the child has ended. */
  std::optional<WorldQuality> Quality();

  /** Returns why the child has ended.
   @pre Step() or Quality() has returned nothing. */
  std::string Reason() { return child_.End().reason; }

  /** Returns the last line that the child has printed to its standard error so far. */
  std::string LastLine() const { return child_.LastLine(); }

 private:
  ChildProcess child_;
};

}  // namespace touchstone
