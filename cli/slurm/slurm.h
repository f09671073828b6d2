#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace touchstone {

/** A task of a job in Slurm's queue. */
struct QueuedTask {
  std::string job;      ///< Id of the job, for an array that of the whole array.
  std::uint64_t index;  ///< Index within the array; 0 if it is none.
  std::string state;    ///< As Slurm writes it, e.g. "RUNNING".
};

/** Parses lines "JOB INDEX STATE"; the index of a job without an array is "N/A". */
std::vector<QueuedTask> ParseQueue(const std::string& text);

/** Returns the tasks of the user that wait or run; empty if Slurm's squeue is missing or
 fails. */
std::optional<std::vector<QueuedTask>> Queue();

/** Splits `text` into words as a shell does, without running commands. Throws InputError.
 */
std::vector<std::string> WordsOf(const std::string& text);

/** Submits a batch script with sbatch and returns the id of the job. Throws InputError if
 sbatch fails; its own message is on standard error. */
std::string Submit(const std::string& script, const std::vector<std::string>& options);

}  // namespace touchstone
