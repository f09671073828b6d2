#include "cli/slurm/batch_script.h"

#include <algorithm>

#include <fmt/format.h>

#include "reports/text/shell_quoted.h"

namespace touchstone {
namespace {

bool StartsWith(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

bool HasJobs(const std::vector<std::string>& arguments) {
  return std::any_of(arguments.begin(), arguments.end(), [](const std::string& argument) {
    return argument == "--jobs" || StartsWith(argument, "--jobs=");
  });
}

}  // namespace

std::vector<std::string> WithoutSlurmOptions(const std::vector<std::string>& arguments) {
  std::vector<std::string> kept;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument == "--slurm" || argument == "--status") continue;
    // Flags may have a value too, as in --slurm=true.
    if (StartsWith(argument, "--slurm=") || StartsWith(argument, "--status=")) continue;
    if (argument == "--tasks" || argument == "--sbatch-args") {
      ++i;
      continue;
    }
    if (StartsWith(argument, "--tasks=") || StartsWith(argument, "--sbatch-args="))
      continue;
    kept.push_back(argument);
  }
  return kept;
}

std::string ArrayOf(const std::vector<std::uint64_t>& tasks) {
  std::string text;
  for (std::size_t i = 0; i < tasks.size();) {
    std::size_t last = i;
    while (last + 1 < tasks.size() && tasks[last + 1] == tasks[last] + 1) ++last;
    text += fmt::format("{}{}", text.empty() ? "" : ",", tasks[i]);
    if (last > i) text += fmt::format("-{}", tasks[last]);
    i = last + 1;
  }
  return text;
}

std::string ShardScript(const SlurmSweep& sweep) {
  std::string command = ShellQuoted(sweep.program);
  for (const std::string& argument : sweep.arguments)
    command += fmt::format(" {}", ShellQuoted(argument));
  if (!HasJobs(sweep.arguments))
    command += " --jobs \"${SLURM_CPUS_PER_TASK:-${SLURM_CPUS_ON_NODE:-1}}\"";
  return fmt::format(
      "#!/bin/sh\n"
      "{} --shard \"$SLURM_ARRAY_TASK_ID\"/{}\n"
      "code=$?\n"
      "# Faults of a subject are results. The task fails only without its file.\n"
      "[ -f {}/sweep.\"$SLURM_ARRAY_TASK_ID\"-of-{}.sqlite ] && exit 0\n"
      "[ \"$code\" -eq 0 ] && exit 1\n"
      "exit \"$code\"\n",
      command, sweep.tasks, ShellQuoted(sweep.folder), sweep.tasks);
}

std::string MergeScript(const SlurmSweep& sweep) {
  const std::string folder = ShellQuoted(sweep.folder);
  return fmt::format(
      "#!/bin/sh\n"
      "# A requeued merge may run beside one on a lost node, hence a file of its own.\n"
      "part={}/slurm/merged.\"$SLURM_JOB_ID\".\"${{SLURM_RESTART_COUNT:-0}}\".sqlite\n"
      "{} merge {}/sweep.*-of-{}.sqlite -o \"$part\"\n"
      "code=$?\n"
      "[ -f \"$part\" ] && exec mv \"$part\" {}/sweep.sqlite\n"
      "[ \"$code\" -eq 0 ] && exit 1\n"
      "exit \"$code\"\n",
      folder, ShellQuoted(sweep.program), folder, sweep.tasks, folder);
}

}  // namespace touchstone
