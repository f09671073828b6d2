#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "oracles/oracle.h"
#include "reports/bench/world_quality.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Settings for timing the steps of a world. */
struct TurnSettings {
  int steps = 240;   ///< Number of timed steps, after as many to settle.
  int seconds = 60;  ///< Limit of CPU time per thread and engine. [s]
  int threads = 1;   ///< Second number of threads to time, for engines that support it.
};

/** The measurements of an engine that took all its steps. */
struct MeasuredSteps {
  double microseconds;  ///< Time per step. [µs]
  double waited;  ///< Fraction of wall time spent waiting for a processor, thread mean.
  WorldQuality quality;  ///< Quality of the final state.
};

/** The result of an oracle with a number of threads. */
struct TimedSteps {
  std::string oracle;
  int threads = 1;
  std::optional<MeasuredSteps> measured;  ///< Empty if the oracle was stopped or crashed.
  /** Indexed by turn; empty if the best one counts. [µs/step] */
  std::vector<double> turns;
  std::string complaint;  ///< Last line printed to standard error.
  std::string reason;     ///< Why nothing was measured.

  /** Returns the oracle and its threads, e.g. "cookbook, 2 threads". */
  std::string Name() const;

  /** Returns the time per step; infinite if nothing was measured. [µs] */
  double Microseconds() const;
};

/** Times the steps of `world` in each oracle with its shipped settings: first in one
 thread, then in TurnSettings::threads if there are more and the oracle supports them.

 Runs `steps` steps to let the bodies settle, then times as many: the benchmark is a pile,
 not bodies in free fall. The engines take turns, so that a temporary slowdown of the
 machine affects all of them alike. With one thread, the time is the median of the CPU
 times of the turns. With several, it is the wall time of the best turn, for all engines.
 @pre Each oracle can simulate `world`.
 @throws std::system_error if the system cannot create a process. */
std::vector<TimedSteps> TimeInTurns(std::span<const Oracle* const> oracles,
                                    const World& world, const TurnSettings& settings);

/** Returns the time of `a` as a multiple of that of `b`. With turns, it is the median of
 the ratios of each turn: a temporary slowdown of the machine affects both times of a
 turn, but not their ratio. The ratio of the medians lacks this property.
 @pre Both were measured in the same call of TimeInTurns(). */
double RatioOf(const TimedSteps& a, const TimedSteps& b);

}  // namespace touchstone
