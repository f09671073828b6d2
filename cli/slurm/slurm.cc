#include "cli/slurm/slurm.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <wordexp.h>

#include "cli/input_error.h"
#include "cli/shell.h"
#include "reports/text/shell_quoted.h"

namespace touchstone {
namespace {

/** Returns the standard output of a shell command; empty if it fails. */
std::optional<std::string> OutputOf(const std::string& command) {
  CommandResult result = RunInShell(command);
  if (result.code != 0) return std::nullopt;
  return std::move(result.text);
}

}  // namespace

std::vector<QueuedTask> ParseQueue(const std::string& text) {
  std::vector<QueuedTask> tasks;
  std::istringstream lines(text);
  std::string job;
  std::string index;
  std::string state;
  while (lines >> job >> index >> state)
    tasks.push_back({job, std::strtoull(index.c_str(), nullptr, 10), state});
  return tasks;
}

std::optional<std::vector<QueuedTask>> Queue() {
  if (!IsInstalled("squeue")) return std::nullopt;
  // A user's environment may hide states and partitions, and a hidden task would be
  // submitted twice.
  const std::optional<std::string> text = OutputOf(
      "env -u SQUEUE_STATES -u SQUEUE_PARTITION -u SQUEUE_ACCOUNT -u SQUEUE_QOS "
      "-u SQUEUE_LICENSES -u SQUEUE_NAMES -u SQUEUE_USERS -u SLURM_CLUSTERS "
      "squeue --me --noheader --array --format='%F %K %T'");
  if (!text) return std::nullopt;
  return ParseQueue(*text);
}

std::vector<std::string> WordsOf(const std::string& text) {
  wordexp_t expanded{};
  const int code = wordexp(text.c_str(), &expanded, WRDE_NOCMD | WRDE_UNDEF);
  if (code != 0) {
    throw InputError(fmt::format(
        "--sbatch-args '{}' cannot be split into words; expected options of sbatch, e.g. "
        "--sbatch-args '--partition=short --time=1:00:00'",
        text));
  }
  std::vector<std::string> words(expanded.we_wordv,
                                 expanded.we_wordv + expanded.we_wordc);
  wordfree(&expanded);
  return words;
}

std::string Submit(const std::string& script, const std::vector<std::string>& options) {
  // To the cluster that Queue() asks.
  std::string command = "env -u SLURM_CLUSTERS -u SBATCH_CLUSTERS sbatch --parsable";
  for (const std::string& option : options)
    command += fmt::format(" {}", ShellQuoted(option));
  std::optional<std::string> id =
      OutputOf(fmt::format("{} {}", command, ShellQuoted(script)));
  if (!id) {
    throw InputError(
        "sbatch refused the job; expected a cluster that accepts it, and valid "
        "--sbatch-args");
  }
  // On a federation the id is followed by ";CLUSTER".
  id->resize(std::min(id->size(), id->find_first_of(";\n")));
  if (id->empty()) {
    throw InputError(
        "sbatch printed no id of a job; expected --sbatch-args that submit one");
  }
  return *id;
}

}  // namespace touchstone
