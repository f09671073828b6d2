#pragma once

#include <string_view>
#include <vector>

#include "scenarios/scenario.h"
#include "scenarios/validate.h"

namespace touchstone {

/** Largest accepted | |n| − 1 | of an expected normal: these are derived by hand and
 written with ten digits; whoever reads one normalises it. */
inline constexpr double kNormalSlack = 1e-9;

/** Returns whether `id` is levels of a-z, 0-9 and _ joined by single slashes. */
bool IsScenarioId(std::string_view id);

/** Returns whether `word` is one or more of a-z, 0-9 and _. */
bool IsWord(std::string_view word);

/** Returns whether `name` is one or more of A-Z, a-z, 0-9, _ and -: a bare key of TOML.
 */
bool IsBodyName(std::string_view name);

/** Returns every fault of `expect`: a finite separation, unit normals to kNormalSlack, a
 count that is not negative. `where` is e.g. "normals[0]". */
std::vector<Fault> FaultsOf(const ContactExpectation& expect);

/** Returns every fault of `tolerance`: a finite separation > 0, and a reason. */
std::vector<Fault> FaultsOf(const ToleranceOverride& tolerance);

/** Returns every fault of `indictments`: an oracle, a measure and an anomaly each.
 `where` is e.g. "indicts[0].oracle". */
std::vector<Fault> FaultsOf(const std::vector<Indictment>& indictments);

/** Returns every fault of what any scenario says of itself: its id, title and source. */
std::vector<Fault> FaultsOfHeading(std::string_view id, std::string_view title,
                                   std::string_view source);

/** Returns every fault of `scenario`, those of its question included; empty for one that
 WriteScenario() can write and ReadScenario() will accept. */
std::vector<Fault> FaultsOf(const Scenario& scenario);

}  // namespace touchstone
