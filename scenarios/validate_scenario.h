#pragma once

#include <string_view>
#include <vector>

#include "scenarios/scenario.h"
#include "scenarios/validate.h"

namespace touchstone {

/** Largest accepted | |n| − 1 | of an expected normal. These normals are derived by hand
 and written with ten digits; code that uses one normalises it first. */
inline constexpr double kNormalSlack = 1e-9;

/** Returns whether `id` consists of levels of a-z, 0-9 and _ joined by single slashes. */
bool IsScenarioId(std::string_view id);

/** Returns whether `word` is one or more of a-z, 0-9 and _. */
bool IsWord(std::string_view word);

/** Returns whether `name` is one or more of A-Z, a-z, 0-9, _ and -: a bare TOML key. */
bool IsBodyName(std::string_view name);

/** Returns every fault of `expect`. Required are a finite separation that agrees with
 `touching`, unit normals to kNormalSlack and a count >= 0. `where` is e.g. "normals[0]".
 */
std::vector<Fault> FaultsOf(const ContactExpectation& expect);

/** Returns every fault of `tolerance`. Required are a finite separation > 0 and a reason.
 */
std::vector<Fault> FaultsOf(const ToleranceOverride& tolerance);

/** Returns every fault of `indictments`. Each needs an oracle, at least one measure and
 an anomaly. `where` is e.g. "indicts[0].oracle". */
std::vector<Fault> FaultsOf(const std::vector<Indictment>& indictments);

/** Returns every fault of the heading that every scenario has: id, title and source. */
std::vector<Fault> FaultsOfHeading(std::string_view id, std::string_view title,
                                   std::string_view source);

/** Returns every fault of `scenario`, including those of its query. It is empty for a
 scenario that WriteScenario() can write and ReadScenario() accepts. */
std::vector<Fault> FaultsOf(const Scenario& scenario);

}  // namespace touchstone
