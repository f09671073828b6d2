#include "cli/commands/triage_command.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/commands/read_failures.h"
#include "cli/input_error.h"
#include "cli/interrupt.h"
#include "cli/output_folder.h"
#include "cli/progress_bar.h"
#include "cli/select_oracles.h"
#include "cli/shell.h"
#include "reports/sweep/sweep_file.h"
#include "reports/text/shell_quoted.h"
#include "reports/triage/known_faults.h"
#include "reports/triage/root_files.h"
#include "reports/triage/triage_index.h"
#include "scenarios/validate_scenario.h"

namespace touchstone {
namespace {

using Clock = std::chrono::steady_clock;

/** Returns the keys of an earlier triage. Throws InputError. */
std::set<std::string> KeysIn(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "roots.txt";
  std::ifstream in(file);
  if (!in) {
    throw InputError(fmt::format(
        "{}: cannot be read; expected the folder of an earlier `touchstone triage`",
        file.string()));
  }
  std::set<std::string> keys;
  for (std::string line; std::getline(in, line);) keys.insert(line);
  return keys;
}

/** The smallest questions of the symptoms, as far as there is time. */
struct Examined {
  std::vector<Specimen> specimens;
  std::size_t left_out = 0;  ///< Symptoms that were not asked again.
};

Examined Examine(const Session& session, const ParallelWork& work, int tries,
                 const std::vector<Symptom>& symptoms) {
  std::vector<std::optional<Specimen>> asked(symptoms.size());
  Examined examined;
  examined.left_out = ForEachInParallel(work, symptoms.size(), [&](std::size_t i) {
    asked[i] =
        AskAgain(symptoms[i], OracleNamed(session.registry, symptoms[i].key.oracle));
  });
  for (std::optional<Specimen>& specimen : asked) {
    if (specimen) examined.specimens.push_back(std::move(*specimen));
  }
  examined.specimens = Joined(std::move(examined.specimens));
  const SmallestOptions options{.tries = static_cast<std::size_t>(tries),
                                .stop = work.stop};
  // Specimens for which no time is left are not shrunk.
  ForEachInParallel(work, examined.specimens.size(), [&](std::size_t i) {
    Specimen& specimen = examined.specimens[i];
    if (specimen.is_repeatable) specimen = Smallest(std::move(specimen), options);
  });
  return examined;
}

/** Builds and runs the program in `folder`, in a folder of its own that is removed. */
ProgramOutput OutputOf(const std::filesystem::path& folder) {
  constexpr int kNotBuilt = 99;
  const CommandResult result = RunInShell(fmt::format(
      "d=$(mktemp -d) || exit {1}; cmake -S {0} -B \"$d\" >\"$d/log\" 2>&1 && "
      "cmake --build \"$d\" >>\"$d/log\" 2>&1 || {{ tail -n 5 \"$d/log\"; rm -rf \"$d\"; "
      "exit {1}; }}; timeout 90 \"$d/reproduce\" 2>&1; code=$?; rm -rf \"$d\"; exit "
      "$code",
      ShellQuoted(std::filesystem::absolute(folder).string()), kNotBuilt));
  switch (result.code) {
    case 0:
      return {result.text, ProgramEnding::kShowsNone};
    case 1:
      return {result.text, ProgramEnding::kShowsFault};
    case kNotBuilt:
      return {result.text, ProgramEnding::kNotBuilt};
    default:
      return {result.text, ProgramEnding::kUnfinished};
  }
}

/** Returns what the index says of a program. */
std::string_view WordsOf(const RootProgram& program,
                         const std::optional<ProgramOutput>& output) {
  if (!program.files) return "none";
  if (!output) return "not run";
  switch (output->ending) {
    case ProgramEnding::kShowsFault:
      return "shows it";
    case ProgramEnding::kShowsNone:
      return "does not show it";
    case ProgramEnding::kNotBuilt:
      return "not built";
    case ProgramEnding::kUnfinished:
      return "unfinished";
  }
  return "";
}

/** Returns a name that no earlier root has. */
std::string UniqueFolder(const Root& root, std::set<std::string>& names) {
  std::string name = FolderOf(root);
  for (int i = 2; !names.insert(name).second; ++i)
    name = fmt::format("{}_{}", FolderOf(root), i);
  return name;
}

/** Returns how the ids of scenarios in `folder` of `path` begin. An id ends the path of
 its file, so that `path`, and what it is in, can be read as catalogues. */
std::string IdOfFolder(const std::filesystem::path& path, const std::string& folder) {
  const std::string id =
      (std::filesystem::absolute(path).filename() / folder).generic_string();
  return IsScenarioId(id) ? id : folder;  // The name of `path` is the user's.
}

/** Writes the folder of a root. */
IndexedRoot WriteRoot(const OutputFolder& out, const std::filesystem::path& path,
                      const Root& root, std::string folder,
                      const std::vector<std::string>& known, bool run_programs) {
  const auto write = [&](const char* name, const std::string& text) {
    out.Write(std::filesystem::path(folder) / name,
              [&](std::ostream& to) { to << text; });
  };
  const std::string id = IdOfFolder(path, folder);
  write("case.toml", CaseFile(root, id + "/case"));
  write("original.toml", OriginalFile(root, id + "/original"));
  const RootProgram program = ProgramOf(root);
  std::optional<ProgramOutput> output;
  if (program.files) {
    write("reproduce.cc", program.files->program);
    write("CMakeLists.txt", program.files->build);
    if (run_programs) output = OutputOf(path / folder);
  }
  write("REPORT.md", ReportOf(root, program, output, known));
  return {.root = &root,
          .folder = std::move(folder),
          .is_new = known.empty(),
          .program = std::string(WordsOf(program, output))};
}

}  // namespace

int TriageCommand(const Session& session, const TriageArguments& arguments) try {
  const std::filesystem::path source = FailuresFileIn(arguments.source);
  std::filesystem::path folder =
      arguments.out.empty() ? source.parent_path() / "triage" : arguments.out;
  if (!folder.has_filename()) folder = folder.parent_path();  // "roots/"
  std::set<std::string> before;
  if (arguments.baseline) before = KeysIn(*arguments.baseline);
  if (std::error_code error; std::filesystem::exists(folder / "index.md", error)) {
    throw InputError(fmt::format(
        "{} holds an earlier triage; expected --out with another folder, or that it is "
        "removed",
        folder.string()));
  }
  const OutputFolder out(folder);

  const Interrupt interrupt(WorkingEngines::kFinish);
  const Clock::time_point start = Clock::now();
  const auto stop = [&] {
    return Interrupt::signal() != 0 ||
           (arguments.time && Clock::now() - start >= *arguments.time);
  };
  const ParallelWork work{.terminal = session.terminal,
                          .quiet = arguments.quiet,
                          .jobs = arguments.jobs,
                          .stop = stop};
  const FoundFailures found = ReadFailures(session, source, arguments.subjects, work);
  const Failures& failures = found.failures;
  Examined examined = Examine(session, work, arguments.tries, failures.symptoms);
  TriageIndex index;
  index.source = source.string();
  index.asked = found.asked;
  index.failed = failures.failed;
  index.unproved = failures.unproved;
  index.vanished = failures.vanished;
  index.unasked = failures.unasked;
  index.left_out = examined.left_out;
  index.is_search = found.is_search;
  index.has_baseline = arguments.baseline.has_value();
  for (const Specimen& specimen : examined.specimens) {
    if (!specimen.is_repeatable) index.unrepeatable.push_back(specimen);
  }
  const std::vector<Root> roots =
      RootsOf(std::move(examined.specimens), failures.asked, found.oracles);
  const Ledger ledger = BuiltInLedger(session, {}, {});
  const Questions catalogue =
      SelectQuestions({.patterns = {}, .catalogues = {session.catalogue()}});
  const bool run_programs = arguments.run_programs && IsInstalled("cmake");
  std::set<std::string> names;
  {
    ProgressBar bar(session.terminal, arguments.quiet);
    for (const Root& root : roots) {
      IndexedRoot entry = WriteRoot(out, folder, root, UniqueFolder(root, names),
                                    KnownFaultsLike(root, ledger, catalogue),
                                    run_programs && Interrupt::signal() == 0);
      const std::vector<std::string> keys = KeyLinesOf(root);
      entry.is_fresh =
          arguments.baseline && !std::ranges::all_of(keys, [&](const std::string& key) {
            return before.contains(key);
          });
      index.roots.push_back(std::move(entry));
      bar.Show(index.roots.size(), roots.size());
    }
  }
  out.Write("index.md", [&](std::ostream& to) { to << IndexPage(index); });
  out.Write("roots.txt", [&](std::ostream& to) { to << KeysFile(roots); });
  const auto fresh = std::ranges::count_if(index.roots, &IndexedRoot::is_fresh);
  std::cout << SummaryOf(index);
  if (arguments.run_programs && !run_programs)
    std::cout << "The programs were not run: cmake is not installed\n";
  std::cout << fmt::format("Wrote {}\n", (folder / "index.md").string());
  if (const int signal = Interrupt::signal()) return 128 + signal;
  // A failure that was not examined may have a new root cause.
  if (index.left_out + index.vanished + index.unasked > 0 || !index.unrepeatable.empty())
    return 1;
  return (arguments.baseline ? fresh > 0 : !roots.empty()) ? 1 : 0;
} catch (const SweepFileError& error) {
  throw InputError(error.what());
}

}  // namespace touchstone
