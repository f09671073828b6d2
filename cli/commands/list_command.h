#pragma once

#include "cli/select_scenarios.h"

namespace touchstone {

/** Prints the ids and titles of the selected scenarios, and their number per group. */
int ListCommand(const ScenarioSelection& selection);

}  // namespace touchstone
