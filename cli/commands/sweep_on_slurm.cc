#include "cli/commands/sweep_on_slurm.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/input_error.h"
#include "cli/output_folder.h"
#include "cli/shell.h"
#include "cli/slurm/batch_script.h"
#include "cli/slurm/slurm.h"
#include "reports/sweep/sweep_file.h"

namespace touchstone {
namespace {

using std::filesystem::path;

/** The default number of shards. */
constexpr std::uint64_t kTasks = 16;

/** The greatest number of shards: Slurm's default limit of an array's indices. */
constexpr std::uint64_t kMaxTasks = 1000;

/** The submissions of a sweep, from the file "slurm/jobs" of its folder: the number of
 tasks, then the ids of all jobs. */
struct Submissions {
  std::uint64_t tasks = 0;  ///< 0: nothing was submitted.
  std::vector<std::string> jobs;
};

Submissions SubmissionsIn(const path& folder) {
  Submissions submissions;
  std::ifstream in(folder / "slurm/jobs");
  in >> submissions.tasks;
  for (std::string job; in >> job;) submissions.jobs.push_back(job);
  return submissions;
}

/** The tasks of this sweep in Slurm's queue: shards from 1 on, and the merge as 0. */
std::map<std::uint64_t, QueuedTask> TasksOf(const Submissions& submissions,
                                            const std::vector<QueuedTask>& queue) {
  std::map<std::uint64_t, QueuedTask> tasks;
  for (const QueuedTask& task : queue) {
    const auto& jobs = submissions.jobs;
    if (std::find(jobs.begin(), jobs.end(), task.job) != jobs.end())
      tasks.emplace(task.index, task);
  }
  return tasks;
}

path FileOf(const path& folder, std::uint64_t shard, std::uint64_t tasks,
            const char* extension) {
  return folder / (FileStemOf({shard - 1, tasks}) + extension);
}

/** The file that keeps the settings of the sweep that was submitted. It has no blocks. */
path PlanIn(const path& folder) {
  return folder / "slurm/plan.sqlite";
}

/** Returns whether sbatch may read `word` as the option `taken`: it accepts a value
 attached to a short option, and any unique start of a long one. */
bool MayMean(const std::string& word, const std::string& taken) {
  const bool is_long = word.starts_with("--");
  if (is_long != taken.starts_with("--")) return false;
  return is_long ? word.size() > 2 && taken.starts_with(word.substr(0, word.find('=')))
                 : word.starts_with(taken);
}

/** Returns the words of --sbatch-args. Throws InputError if they hold an option on which
 the paths and ids of the sweep depend. */
std::vector<std::string> OwnOptions(const std::string& sbatch_args) {
  std::vector<std::string> words = WordsOf(sbatch_args);
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.find('='));
    for (const char* const taken :
         {"--array", "-a", "--dependency", "-d", "--chdir", "-D", "--clusters", "-M",
          "--output", "-o", "--test-only", "--kill-on-invalid-dep", "--wrap", "--wait",
          "-W"}) {
      if (!MayMean(word, taken)) continue;
      throw InputError(fmt::format(
          "--sbatch-args: {} is set by the sweep itself; expected options of resources, "
          "e.g. --partition, --time, --cpus-per-task, --mem",
          name));
    }
  }
  return words;
}

/** Returns the number of tasks. Throws InputError if it does not fit the sweep. */
std::uint64_t TasksOf(const path& folder, const SweepPlan& plan, std::uint64_t submitted,
                      std::optional<std::uint64_t> wanted) {
  const std::uint64_t blocks = BlockCount(plan);
  const std::uint64_t block = BlockSizeOf(plan.series.front());
  if (blocks < 2) {
    throw InputError(
        fmt::format("--slurm: the sweep has one block of at most {} questions, which "
                    "cannot be divided; expected more questions, or no --slurm",
                    block));
  }
  const std::uint64_t tasks =
      wanted.value_or(submitted > 0 ? submitted : std::min(kTasks, blocks));
  if (submitted > 0 && tasks != submitted) {
    throw InputError(
        fmt::format("{} was submitted with --tasks {}; expected the same, or "
                    "another folder",
                    folder.string(), submitted));
  }
  const std::uint64_t most = std::min(blocks, kMaxTasks);
  if (tasks < 2 || tasks > most) {
    throw InputError(fmt::format(
        "--tasks {}: the sweep has {} blocks of up to {} questions, and Slurm takes "
        "arrays of up to {}; expected 2 to {}",
        tasks, blocks, block, kMaxTasks, most));
  }
  return tasks;
}

/** Returns `file` as a pattern of sbatch, in which % is special. */
std::string Pattern(const path& file) {
  std::string pattern;
  for (const char c : file.string()) pattern += c == '%' ? "%%" : std::string(1, c);
  return pattern;
}

/** Returns the progress of a shard that is not in the queue. */
std::string ProgressOf(const SweepPlan& plan, const path& folder, std::uint64_t shard,
                       std::uint64_t tasks) {
  const path file = FileOf(folder, shard, tasks, ".unfinished.sqlite");
  if (!std::filesystem::exists(file)) return "not begun";
  try {
    return fmt::format("stopped after {} of {} blocks",
                       SweepFile::Open(file).blocks().size(),
                       Shard{shard - 1, tasks}.SizeOf(BlockCount(plan)));
  } catch (const SweepFileError&) {
    return "a process has its file open";
  }
}

/** Returns the last line of progress in a shard's log; empty if there is none. */
std::string LastProgress(const path& log) {
  std::ifstream in(log);
  std::string last;
  for (std::string line; std::getline(in, line);) {
    if (line.find(" a second") != std::string::npos) last = line;
  }
  const std::size_t text = last.find(": ");
  return text == std::string::npos ? "" : ", " + last.substr(text + 2);
}

}  // namespace

int SubmitSweep(const SweepPlan& plan, const SweepArguments& arguments) {
  if (!IsInstalled("sbatch")) {
    throw InputError(
        "--slurm: there is no sbatch; expected the commands of Slurm on the PATH "
        "(without "
        "Slurm, --shard K/N divides a sweep)");
  }
  const path& folder = *arguments.out;
  const SweepSettings settings = SettingsOf(plan);
  if (std::filesystem::exists(folder / "sweep.sqlite")) {
    SweepFile::Open(folder / "sweep.sqlite").Require(settings);
    std::cout << fmt::format("complete: {}\n", (folder / "sweep.sqlite").string());
    return 0;
  }
  Submissions submissions = SubmissionsIn(folder);
  const std::uint64_t tasks =
      TasksOf(folder, plan, submissions.tasks, arguments.slurm.tasks);
  const std::vector<std::string> own_options = OwnOptions(arguments.slurm.sbatch_args);
  const auto queue = Queue();
  if (!queue) {
    throw InputError(
        "--slurm: squeue does not answer; expected a cluster that can be reached");
  }
  const OutputFolder out(*arguments.out);
  std::filesystem::create_directories(folder / "slurm");
  // The settings of a submission that no cluster took bind nobody.
  if (submissions.jobs.empty()) std::filesystem::remove(PlanIn(folder));
  // Held until the jobs are noted: a second submission at the same time waits or fails.
  const SweepFile held = SweepFile::Resume(PlanIn(folder), settings);
  const auto queued = TasksOf(submissions, *queue);
  std::vector<std::uint64_t> missing;
  std::set<std::string> awaited;  // Jobs and tasks before the merge.
  for (std::uint64_t shard = 1; shard <= tasks; ++shard) {
    const path complete = FileOf(folder, shard, tasks, ".sqlite");
    if (std::filesystem::exists(complete)) {
      SweepFile::Open(complete).Require(settings);
    } else if (const auto found = queued.find(shard); found != queued.end()) {
      if (found->second.state == "COMPLETING") {
        throw InputError(fmt::format(
            "shard {} is about to end; expected the same command in a moment", shard));
      }
      awaited.insert(fmt::format("{}_{}", found->second.job, shard));
    } else {
      missing.push_back(shard);
    }
  }
  if (missing.empty() && queued.contains(0)) {
    std::cout << "nothing to submit: every shard is complete or in the queue\n";
    return 0;
  }

  const SlurmSweep sweep{.program = std::filesystem::read_symlink("/proc/self/exe"),
                         .arguments = WithoutSlurmOptions(arguments.slurm.words),
                         .folder = folder.string(),
                         .tasks = tasks};
  const auto write = [&](const char* name, const std::string& text) {
    out.Write(name, [&](std::ostream& to) { to << text; });
  };
  write("slurm/shard.sh", ShardScript(sweep));
  write("slurm/merge.sh", MergeScript(sweep));
  submissions.tasks = tasks;
  const auto submit = [&](const char* script, std::vector<std::string> options) {
    options.insert(options.begin(), own_options.begin(), own_options.end());
    submissions.jobs.push_back(Submit((folder / script).string(), options));
    write("slurm/jobs.new",
          fmt::format("{}\n{}\n", tasks, fmt::join(submissions.jobs, "\n")));
    std::filesystem::rename(folder / "slurm/jobs.new", folder / "slurm/jobs");
    return submissions.jobs.back();
  };
  if (!missing.empty()) {
    const std::string job = submit(
        "slurm/shard.sh", {"--job-name=touchstone-sweep", "--requeue",
                           "--open-mode=append", "--array=" + ArrayOf(missing),
                           "--output=" + Pattern(folder / "slurm/shard-") + "%a.log"});
    awaited.insert(job);
    std::cout << fmt::format("shards {} of {}: job {}\n", ArrayOf(missing), tasks, job);
  }
  std::vector<std::string> options = {"--job-name=touchstone-merge", "--requeue",
                                      "--open-mode=append", "--kill-on-invalid-dep=yes",
                                      "--output=" + Pattern(folder / "slurm/merge.log")};
  if (!awaited.empty())
    options.push_back(fmt::format("--dependency=afterok:{}", fmt::join(awaited, ":")));
  const std::string merge = submit("slurm/merge.sh", options);
  std::cout << fmt::format(
      "merge into {}: job {}\n"
      "The same command with --status shows the progress; without it, it submits again "
      "what has failed.\n",
      (folder / "sweep.sqlite").string(), merge);
  return 0;
}

int PrintSlurmStatus(const SweepPlan& plan, const SweepArguments& arguments) {
  const path& folder = *arguments.out;
  const Submissions submissions = SubmissionsIn(folder);
  if (submissions.tasks == 0) {
    throw InputError(fmt::format(
        "{}: no sweep was submitted; expected the folder of `touchstone sweep --slurm`",
        folder.string()));
  }
  const path merged = folder / "sweep.sqlite";
  const bool complete = std::filesystem::exists(merged);
  SweepFile::Open(complete ? merged : PlanIn(folder)).Require(SettingsOf(plan));
  const auto queue = Queue();
  const auto queued = TasksOf(submissions, queue.value_or(std::vector<QueuedTask>()));
  for (std::uint64_t shard = 1; shard <= submissions.tasks; ++shard) {
    std::string state;
    if (std::filesystem::exists(FileOf(folder, shard, submissions.tasks, ".sqlite"))) {
      state = "complete";
    } else if (const auto found = queued.find(shard); found != queued.end()) {
      state = found->second.state +
              LastProgress(folder / fmt::format("slurm/shard-{}.log", shard));
    } else {
      state = ProgressOf(plan, folder, shard, submissions.tasks);
      if (!queue) state += ", as far as known: squeue does not answer";
    }
    std::cout << fmt::format("shard {:>4} of {}  {}\n", shard, submissions.tasks, state);
  }
  std::string merge = "not in the queue; the command without --status submits again";
  if (complete)
    merge = "complete";
  else if (queued.contains(0))
    merge = queued.at(0).state;
  else if (!queue)
    merge = "unknown: squeue does not answer";
  std::cout << fmt::format("merge  {}\n", merge);
  return complete ? 0 : 1;
}

}  // namespace touchstone
