#pragma once

#include <optional>
#include <string>

#include <sys/types.h>

#include "cli/error_output.h"
#include "oracles/oracle.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Quality of the state of a simulated world. Sent as plain bytes. */
struct WorldQuality {
  double deepest = 0;   ///< Deepest penetration of two bodies. [m]
  double fastest = 0;   ///< Largest speed of a body. [m/s]
  double sideways = 0;  ///< Largest horizontal displacement of a body; y is up. [m]
};

/** Average time of a step. Sent as plain bytes. [µs] */
struct StepTime {
  double cpu = 0;   ///< CPU time of the thread that requests the step, without helpers.
  double wall = 0;  ///< Wall time, including other work of the machine.
  /** Time for which threads were ready to run but had no processor, summed over threads;
   0 if the system does not report it. */
  double waited = 0;
};

/** Settings for stepping an engine. */
struct Stepping {
  int threads = 1;   ///< Number of threads that share a step.
  int seconds = 60;  ///< Limit of CPU time per thread; at their sum the child stops. [s]
};

/** An engine that steps a world in its own process, on demand. Several engines can thus
 take turns, and an engine that crashes or takes hours for a step loses only its own
 results. */
class SteppingChild {
 public:
  /** Starts the child process.
   @pre `oracle` can simulate `world` with the requested number of threads; both outlive
   this object.
   @throws InputError if the system cannot create the process. */
  SteppingChild(const Oracle& oracle, const World& world, const Stepping& stepping);

  /** Ends the child. */
  ~SteppingChild();

  SteppingChild(const SteppingChild&) = delete;
  SteppingChild& operator=(const SteppingChild&) = delete;

  /** Takes `steps` > 0 steps. Returns the average time of one; empty once the child has
   ended. */
  std::optional<StepTime> Step(int steps);

  /** Returns the quality of the current state; empty once the child has ended. */
  std::optional<WorldQuality> Quality();

  /** Returns the last line that the child has printed to its standard error so far. */
  std::string LastLine() const { return error_output_.LastLine(); }

 private:
  [[noreturn]] static void Run(const Oracle& oracle, const World& world, int threads,
                               int orders);
  template <typename Reply>
  std::optional<Reply> Ask(int steps);

  ErrorOutput error_output_;
  pid_t pid_ = -1;
  int orders_ =
      -1;  ///< The parent's end: sends the number of steps, or 0 for the quality.
};

}  // namespace touchstone
