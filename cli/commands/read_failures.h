#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/commands/parallel_work.h"
#include "cli/session.h"
#include "reports/triage/symptom.h"

namespace touchstone {

/** The failures of a sweep or a run, and who was asked. */
struct FoundFailures {
  Failures failures;
  std::vector<const Oracle*> oracles;  ///< Those that were asked.
  std::string asked;                   ///< Their names and versions.
  bool is_search = false;              ///< Whether questions depend on the answers.
};

/** Returns the file of a finished sweep, or the data of a run, that `path` is or holds.
 Throws InputError, also for a sweep that is not finished. */
std::filesystem::path FailuresFileIn(const std::filesystem::path& path);

/** Reads the failures of the oracles that `wanted` names, all if it is empty, from a file
 of FailuresFileIn(). The failed answers of a run are asked for again. Throws InputError
 or SweepFileError. */
FoundFailures ReadFailures(const Session& session, const std::filesystem::path& file,
                           const std::string& wanted, const ParallelWork& work);

}  // namespace touchstone
