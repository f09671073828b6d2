#pragma once

#include "cli/commands/sweep_command.h"
#include "reports/sweep/sweep_plan.h"

namespace touchstone {

/** Submits the shards of a sweep that are neither complete nor in the queue, as an array
 job, and a job that merges them once all have succeeded. Prints the ids of the jobs.
 Returns 0. Throws InputError without Slurm, and SweepFileError if the folder has results
 of another sweep. @pre `arguments.out`. */
int SubmitSweep(const SweepPlan& plan, const SweepArguments& arguments);

/** Prints the progress of each shard and of the merge. Submits nothing. Returns 0 if the
 sweep is complete, else 1. Throws InputError if no sweep was submitted for the folder.
 @pre `arguments.out`. */
int PrintSlurmStatus(const SweepPlan& plan, const SweepArguments& arguments);

}  // namespace touchstone
