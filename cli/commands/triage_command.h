#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "cli/session.h"

namespace touchstone {

/** The arguments of `touchstone triage`. */
struct TriageArguments {
  /** The folder of a finished sweep or a run, its sweep.sqlite or its report.data. */
  std::filesystem::path source;
  std::filesystem::path out;  ///< Empty: the folder `triage` beside that file.
  std::string subjects;       ///< Names or groups; empty: all that were asked.
  /** The folder of an earlier triage; its roots are not new. */
  std::optional<std::filesystem::path> baseline;
  int tries = 300;  ///< Same as SmallestOptions::tries.
  /** The time after which no further kind of failure is examined. */
  std::optional<std::chrono::seconds> time;
  bool run_programs = true;  ///< Build and run the programs.
  int jobs = 0;
  bool quiet = false;
};

/** Examines the failures that a sweep has kept, or a run has found, and writes a folder a
 root cause, and an index. Returns 1 if there are any, of a baseline any that it lacks,
 otherwise 0. Throws InputError. */
int TriageCommand(const Session& session, const TriageArguments& arguments);

}  // namespace touchstone
