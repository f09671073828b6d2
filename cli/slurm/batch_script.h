#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace touchstone {

/** Returns the arguments of a sweep without those that only concern Slurm: `--slurm`,
 `--status`, `--tasks N` and `--sbatch-args TEXT`, also with `=`. */
std::vector<std::string> WithoutSlurmOptions(const std::vector<std::string>& arguments);

/** Returns the indices of an array job as sbatch reads them, e.g. "1,3-5".
 @pre `tasks` ascends. */
std::string ArrayOf(const std::vector<std::uint64_t>& tasks);

/** The commands of a sweep on a cluster. */
struct SlurmSweep {
  std::string program;                 ///< Path of this program.
  std::vector<std::string> arguments;  ///< Those of the sweep, see WithoutSlurmOptions().
  std::string folder;                  ///< Folder of the results.
  std::uint64_t tasks;                 ///< Number of shards.
};

/** Returns the batch script of one task, which sweeps the shard of its index. It succeeds
 exactly if the file of the shard is complete: a fault of a subject is a result. It uses
 the processors that Slurm granted, unless the arguments have `--jobs`. */
std::string ShardScript(const SlurmSweep& sweep);

/** Returns the batch script that merges the shards. */
std::string MergeScript(const SlurmSweep& sweep);

}  // namespace touchstone
