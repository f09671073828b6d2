#pragma once

#include <optional>

#include <sys/types.h>

#include "oracles/oracle.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** What a world of an engine is worth; plain bytes. */
struct WorldQuality {
  double deepest = 0;   ///< Overlap of two bodies. [m]
  double fastest = 0;   ///< Speed of a body. [m/s]
  double sideways = 0;  ///< Farthest way of a body across gravity, along y. [m]
};

/** An engine that steps a world in a process of its own when it is told to, so that
 several take turns, and one that takes hours for a step, or dies of it, loses its own
 answers only.
 */
class SteppingChild {
 public:
  /** @param seconds CPU time after which the child is stopped.
   @pre `oracle` simulates `world`; both outlive this.
   @throws InputError where the system gives no process. */
  SteppingChild(const Oracle& oracle, const World& world, int seconds);

  /** Ends the child. */
  ~SteppingChild();

  SteppingChild(const SteppingChild&) = delete;
  SteppingChild& operator=(const SteppingChild&) = delete;

  /** Takes `steps` > 0 steps. Returns the CPU time of its thread for one, on the average;
   nothing once the child has ended. [µs] */
  std::optional<double> Step(int steps);

  /** Returns what the world is worth now; nothing once the child has ended. */
  std::optional<WorldQuality> Quality();

 private:
  [[noreturn]] static void Run(const Oracle& oracle, const World& world, int orders);
  template <typename Reply>
  std::optional<Reply> Ask(int steps);

  pid_t pid_ = -1;
  int orders_ =
      -1;  ///< Our end: the steps to take, or 0 for the quality; then the reply.
};

}  // namespace touchstone
