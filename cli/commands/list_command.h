#pragma once

#include "cli/select_scenarios.h"

namespace touchstone {

/** Prints the id and the title of the selected scenarios, and their number per group. */
int ListCommand(const ScenarioSelection& selection);

}  // namespace touchstone
