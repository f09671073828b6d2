#include "cli/commands/sweep_command.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "cli/commands/sweep_on_slurm.h"
#include "cli/commands/sweep_summary.h"
#include "cli/did_you_mean.h"
#include "cli/input_error.h"
#include "cli/interrupt.h"
#include "cli/output_folder.h"
#include "cli/progress_bar.h"
#include "reports/sweep/merge.h"
#include "reports/sweep/sweep.h"
#include "reports/writers/explanation_writer.h"
#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

using Clock = std::chrono::steady_clock;
using KindPair = std::pair<ShapeKind, ShapeKind>;

std::vector<Family> FamiliesNamed(const std::vector<std::string>& names) {
  std::vector<Family> families;
  for (const std::string& name : names) {
    if (name == "all") return AllFamilies();
    const std::optional<Family> family = FamilyNamed(name);
    if (!family) {
      std::vector<std::string_view> known = {"all"};
      for (const Family each : AllFamilies()) known.push_back(NameOf(each));
      throw InputError(fmt::format("there is no family '{}'{}; expected one of: {}", name,
                                   DidYouMean(name, known), fmt::join(known, ", ")));
    }
    if (std::find(families.begin(), families.end(), *family) == families.end())
      families.push_back(*family);
  }
  return families;
}

ShapeKind KindNamed(const std::string& name) {
  std::array<std::string_view, kShapeKinds> names;
  for (int i = 0; i < kShapeKinds; ++i) {
    const ShapeKind kind = static_cast<ShapeKind>(i);
    if (NameOf(kind) == name) return kind;
    names[static_cast<std::size_t>(i)] = NameOf(kind);
  }
  throw InputError(fmt::format("there is no shape '{}'{}; expected one of: {}", name,
                               DidYouMean(name, names), fmt::join(names, ", ")));
}

std::vector<KindPair> PairsOf(const SweepArguments& arguments,
                              const std::vector<const Oracle*>& subjects) {
  std::vector<KindPair> pairs;
  for (const auto& [A, B] : arguments.pairs) {
    const KindPair pair = PairNamed({A, B});
    if (std::find(pairs.begin(), pairs.end(), pair) == pairs.end()) pairs.push_back(pair);
  }
  if (!pairs.empty()) return pairs;
  for (int a = 0; a < kShapeKinds; ++a) {
    for (int b = 0; b < kShapeKinds; ++b) {
      const KindPair pair(static_cast<ShapeKind>(a), static_cast<ShapeKind>(b));
      if (std::any_of(subjects.begin(), subjects.end(), [&pair](const Oracle* subject) {
            return subject->info().For(pair.first, pair.second).supported;
          })) {
        pairs.push_back(pair);
      }
    }
  }
  return pairs;
}

SweepPlan PlanOf(const Session& session, const SweepArguments& arguments) {
  SweepPlan plan;
  plan.subjects = SubjectsNamed(session.registry, arguments.oracles.subject);
  if (!arguments.oracles.against.empty()) {
    OracleSelection selection = arguments.oracles;
    selection.subject = plan.subjects.front()->info().name;
    const std::vector<const Oracle*> oracles = SelectOracles(session.registry, selection);
    plan.references.assign(oracles.begin() + 1, oracles.end());
  }
  const std::vector<KindPair> pairs = PairsOf(arguments, plan.subjects);
  for (const Family family : FamiliesNamed(arguments.families)) {
    for (const auto& [A, B] : pairs) {
      plan.series.push_back({.family = family,
                             .A = A,
                             .B = B,
                             .seed = arguments.seed,
                             .first = arguments.first,
                             .count = arguments.count,
                             .climb = arguments.climb});
    }
  }
  return plan;
}

/** The file of a sweep, and whether all of its blocks are in it. */
struct Swept {
  SweepFile file;
  bool complete;
};

/** Sweeps into a file in `folder`, or resumes a sweep that was interrupted there. The
 unfinished file has another name, so that a complete one is never changed. */
Swept SweepInto(const std::filesystem::path& folder, const SweepPlan& plan,
                const SweepOptions& options) {
  const SweepSettings settings = SettingsOf(plan);
  const std::filesystem::path complete = folder / (FileStemOf(options.shard) + ".sqlite");
  const std::filesystem::path unfinished =
      folder / (FileStemOf(options.shard) + ".unfinished.sqlite");
  if (!std::filesystem::exists(complete)) {
    SweepFile file = SweepFile::Resume(unfinished, settings);
    if (!Sweep(plan, file, options)) return {std::move(file), false};
    WritePart(file, complete);
  }
  SweepFile file = SweepFile::Open(complete);
  file.Require(settings);
  std::error_code ignored;
  for (const char* const end : {"", "-wal", "-shm"})
    std::filesystem::remove(unfinished.string() + end, ignored);
  return {std::move(file), true};
}

Swept SweepInMemory(const SweepPlan& plan, const SweepOptions& options) {
  SweepFile file = SweepFile::Create(":memory:", SettingsOf(plan), SweepJournal::kNone);
  const bool complete = Sweep(plan, file, options);
  return {std::move(file), complete};
}

Scenario ScenarioOf(const FailedQuestion& failure) {
  return ReadScenario(failure.scenario, "a kept failure").scenario.value();
}

/** Writes the failed questions that the file keeps as scenario files. */
void WriteFailures(const OutputFolder& folder, const SweepFile& file) {
  for (std::size_t s = 0; s < file.settings().series.size(); ++s) {
    for (const OracleTally& tally : file.Read(s).oracles) {
      for (const auto& [kind, failures] : tally.failures) {
        for (const FailedQuestion& failure : failures) {
          folder.Write(ScenarioOf(failure).id + ".toml",
                       [&](std::ostream& out) { out << failure.scenario; });
        }
      }
    }
  }
}

/** Prints the worst failure of each cluster, the largest first, next to the answers of
 the references. */
void ExplainFailures(const Session& session, const SweepArguments& arguments,
                     const SweepFile& file, const SubjectSummary& subject) {
  constexpr std::size_t kShown = 3;
  OracleSelection selection = arguments.oracles;
  selection.subject = file.settings().subjects.front();
  const std::vector<const Oracle*> oracles = SelectOracles(session.registry, selection);
  std::vector<const FailureCluster*> clusters;
  for (const auto& [kind, cluster] : subject.clusters) {
    if (cluster.worst) clusters.push_back(&cluster);
  }
  std::stable_sort(clusters.begin(), clusters.end(),
                   [](const FailureCluster* a, const FailureCluster* b) {
                     return a->count > b->count;
                   });
  for (std::size_t i = 0; i < clusters.size() && i < kShown; ++i) {
    const QuestionSeries& series = file.settings().series[clusters[i]->series];
    const std::uint64_t question = clusters[i]->worst->question;
    const Scenario scenario = ScenarioOf(*clusters[i]->worst);
    RunOptions options;
    options.jobs = arguments.jobs;
    options.partial = true;
    std::cout << '\n' << clusters[i]->worst->scenario << '\n';
    WriteExplanation(Run({&scenario, 1}, oracles, {}, options), {}, std::cout);
    std::cout << "Repeat with: " << ReplayOf(series, question) << '\n';
  }
}

/** Returns the exit code of what was swept. */
int ExitCodeOf(const SweepFile& file, const std::vector<SubjectSummary>& subjects,
               bool all_subjects) {
  const auto any = [&subjects](auto is_so) {
    return std::any_of(subjects.begin(), subjects.end(), is_so);
  };
  if (any([](const SubjectSummary& s) { return s.failed_in_band > 0; })) return 1;
  const auto is_verified = [](const SubjectSummary& s) {
    return s.verified_touching > 0;
  };
  // With `all`, nobody has said that each of them supports the shapes.
  if (all_subjects && any(is_verified)) return 0;
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    if (is_verified(subjects[i])) continue;
    std::cerr << "touchstone: nothing was verified; expected a touching question that "
              << file.settings().subjects[i] << " supports\n";
    return 2;
  }
  return 0;
}

/** Throws InputError if the options do not fit a sweep on a cluster. */
void CheckSlurm(const SweepArguments& arguments) {
  const SlurmArguments& slurm = arguments.slurm;
  if (!slurm.submit) {
    if (!slurm.status && !slurm.tasks && slurm.sbatch_args.empty()) return;
    throw InputError(
        "--status, --tasks and --sbatch-args belong to --slurm; expected it");
  }
  if (!arguments.out)
    throw InputError("--slurm: expected --out DIR, a folder that all machines share");
  if (arguments.shard.count > 1)
    throw InputError("--slurm chooses the shards itself; expected --tasks, not --shard");
  if (arguments.time) {
    throw InputError(
        "--time stops a task before its shard is complete; expected --sbatch-args "
        "--time=..., after which the same command submits again");
  }
}

}  // namespace

std::string FileStemOf(const Shard& shard) {
  // A single shard is the whole sweep.
  return shard.count == 1 ? "sweep"
                          : fmt::format("sweep.{}-of-{}", shard.index + 1, shard.count);
}

std::pair<ShapeKind, ShapeKind> PairNamed(const std::vector<std::string>& names) {
  const KindPair pair(KindNamed(names[0]), KindNamed(names[1]));
  if (pair == KindPair(ShapeKind::kHalfSpace, ShapeKind::kHalfSpace)) {
    throw InputError(
        "two half-spaces are not a valid pair; expected at least one other shape");
  }
  return pair;
}

int SweepCommand(const Session& session, const SweepArguments& arguments) try {
  CheckSlurm(arguments);
  const SweepPlan plan = PlanOf(session, arguments);
  if (arguments.slurm.status) return PrintSlurmStatus(plan, arguments);
  if (arguments.slurm.submit) return SubmitSweep(plan, arguments);
  std::optional<OutputFolder> out;
  if (arguments.out) out.emplace(*arguments.out);
  const Interrupt interrupt;
  const Clock::time_point start = Clock::now();
  const auto is_time_over = [&] {
    return arguments.time && Clock::now() - start >= *arguments.time;
  };
  std::optional<ProgressBar> bar;
  bar.emplace(session.terminal, arguments.quiet);
  const SweepOptions options{
      .jobs = arguments.jobs,
      .shard = arguments.shard,
      .stop = [&] { return Interrupt::signal() != 0 || is_time_over(); },
      .on_progress = [&bar](std::uint64_t done,
                            std::uint64_t total) { bar->Show(done, total); }};
  const Swept swept = arguments.out ? SweepInto(*arguments.out, plan, options)
                                    : SweepInMemory(plan, options);
  bar.reset();
  const std::vector<SubjectSummary> subjects =
      PrintSweepTable(swept.file, arguments.fail_on);
  if (out) WriteFailures(*out, swept.file);
  const bool is_explained = subjects.size() == 1 && !arguments.quiet && swept.complete &&
                            subjects.front().failed > 0;
  if (is_explained) ExplainFailures(session, arguments, swept.file, subjects.front());
  PrintFailureClusters(swept.file, subjects);
  if (!swept.complete) {
    std::cout.flush();
    std::cerr << fmt::format(
        "touchstone: stopped after {} of {} blocks; {}\n", swept.file.blocks().size(),
        arguments.shard.SizeOf(BlockCount(plan)),
        arguments.out ? "the same command goes on from there"
                      : "with --out, the same command would go on from there");
    if (const int signal = Interrupt::signal()) return 128 + signal;
  }
  return ExitCodeOf(swept.file, subjects, arguments.oracles.subject == "all");
} catch (const SweepFileError& error) {
  throw InputError(error.what());
}

}  // namespace touchstone
