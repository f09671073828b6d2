#pragma once

#include <optional>
#include <string>

#include <sys/types.h>

#include "cli/error_output.h"
#include "oracles/oracle.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** What a world of an engine is worth; plain bytes. */
struct WorldQuality {
  double deepest = 0;   ///< Overlap of two bodies. [m]
  double fastest = 0;   ///< Speed of a body. [m/s]
  double sideways = 0;  ///< Farthest way of a body across gravity, along y. [m]
};

/** What a step takes, on the average; plain bytes. [µs] */
struct StepTime {
  double cpu = 0;   ///< Of the thread that asks for the step; without those that help it.
  double wall = 0;  ///< From its start to its end, whatever else the machine did.
  /** In which a thread could have run and found no processor, all threads added; 0 where
   the system does not tell. */
  double waited = 0;
};

/** How an engine is stepped. */
struct Stepping {
  int threads = 1;   ///< That share a step.
  int seconds = 60;  ///< CPU time a thread; when all is spent, the child is stopped.
};

/** An engine that steps a world in a process of its own when it is told to, so that
 several take turns, and one that takes hours for a step, or dies of it, loses its own
 answers only.
 */
class SteppingChild {
 public:
  /** @pre `oracle` simulates `world`, in several threads where it is to; both outlive
   this.
   @throws InputError where the system gives no process. */
  SteppingChild(const Oracle& oracle, const World& world, const Stepping& stepping);

  /** Ends the child. */
  ~SteppingChild();

  SteppingChild(const SteppingChild&) = delete;
  SteppingChild& operator=(const SteppingChild&) = delete;

  /** Takes `steps` > 0 steps. Returns the time of one; nothing once the child has ended.
   */
  std::optional<StepTime> Step(int steps);

  /** Returns what the world is worth now; nothing once the child has ended. */
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
      -1;  ///< Our end: the steps to take, or 0 for the quality; then the reply.
};

}  // namespace touchstone
