#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/sweep/sweep_plan.h"

namespace touchstone {

/** All that the result of a sweep depends on. Two sweeps with equal settings have equal
 results; their blocks may be merged. */
struct SweepSettings {
  /** Names and values: versions of the program and of the oracles, stated tolerances,
   setups of worlds, limits. */
  std::map<std::string, std::string> values;
  std::vector<Series> series;
  std::vector<std::string> subjects;  ///< Names.
};

/** Returns the settings of `plan` in this program. */
SweepSettings SettingsOf(const SweepPlan& plan);

/** Returns the first difference in words, e.g. "seed 1, not 2"; empty if they are equal.
 */
std::optional<std::string> DifferenceOf(const SweepSettings& has,
                                        const SweepSettings& wanted);

}  // namespace touchstone
