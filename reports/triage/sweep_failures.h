#pragma once

#include <set>
#include <string>

#include "reports/sweep/sweep_file.h"
#include "reports/triage/symptom.h"

namespace touchstone {

/** Returns the failures of `oracles`, by name, in a sweep. Throws SweepFileError, also if
 a kept question cannot be read. */
Failures FailuresOf(const SweepFile& file, const std::set<std::string>& oracles);

}  // namespace touchstone
