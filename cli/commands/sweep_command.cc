#include "cli/commands/sweep_command.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iostream>
#include <map>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands/sweep_on_slurm.h"
#include "cli/commands/sweep_summary.h"
#include "cli/did_you_mean.h"
#include "cli/input_error.h"
#include "cli/interrupt.h"
#include "cli/output_folder.h"
#include "cli/progress_bar.h"
#include "reports/sweep/merge.h"
#include "reports/sweep/read_file_series.h"
#include "reports/sweep/sweep.h"
#include "reports/text/commented.h"
#include "reports/text/counted.h"
#include "reports/writers/explanation_writer.h"
#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

using Clock = std::chrono::steady_clock;
using KindPair = std::pair<ShapeKind, ShapeKind>;

/** The number of generated questions of a series. */
constexpr std::uint64_t kCount = 200;

constexpr std::uint64_t kSeed = 1;

/** Returns the families with those names, each once, or `all` for the name "all". Throws
 InputError for an unknown name. */
template <typename AnyFamily>
std::vector<AnyFamily> FamiliesNamed(
    const std::vector<std::string>& names, const std::vector<AnyFamily>& all,
    std::optional<AnyFamily> (*family_named)(std::string_view)) {
  std::vector<AnyFamily> families;
  for (const std::string& name : names) {
    if (name == "all") return all;
    const std::optional<AnyFamily> family = family_named(name);
    if (!family) {
      std::vector<std::string_view> known = {"all"};
      for (const AnyFamily each : all) known.push_back(NameOf(each));
      throw InputError(fmt::format("there is no family '{}'{}; expected one of: {}", name,
                                   DidYouMean(name, known), fmt::join(known, ", ")));
    }
    if (std::find(families.begin(), families.end(), *family) == families.end())
      families.push_back(*family);
  }
  return families;
}

/** @pre `name` is that of a shape; the command line refuses others. */
ShapeKind KindNamed(const std::string& name) {
  int kind = 0;
  while (NameOf(static_cast<ShapeKind>(kind)) != name) ++kind;
  return static_cast<ShapeKind>(kind);
}

/** Returns the pairs of --pair, each once. */
std::vector<KindPair> ChosenPairs(const SweepArguments& arguments) {
  std::vector<KindPair> pairs;
  for (const auto& [A, B] : arguments.pairs) {
    const KindPair pair = PairNamed({A, B});
    if (std::find(pairs.begin(), pairs.end(), pair) == pairs.end()) pairs.push_back(pair);
  }
  return pairs;
}

/** Returns the pairs of --pair, or those that a subject supports, each in one order: the
 other order is a variant of every question. Both, if some subject supports one order
 only. */
std::vector<KindPair> PairsOf(const SweepArguments& arguments,
                              const std::vector<const Oracle*>& subjects) {
  std::vector<KindPair> pairs = ChosenPairs(arguments);
  if (!pairs.empty()) return pairs;
  for (int a = 0; a < kShapeKinds; ++a) {
    for (int b = a; b < kShapeKinds; ++b) {
      const auto A = static_cast<ShapeKind>(a);
      const auto B = static_cast<ShapeKind>(b);
      std::set<KindPair> orders;
      for (const Oracle* subject : subjects) {
        if (subject->info().For(A, B).supported)
          orders.emplace(A, B);
        else if (subject->info().For(B, A).supported)
          orders.emplace(B, A);
      }
      pairs.insert(pairs.end(), orders.begin(), orders.end());
    }
  }
  return pairs;
}

std::vector<Series> ContactSeries(const SweepArguments& arguments,
                                  const std::vector<const Oracle*>& subjects) {
  std::vector<Series> series;
  const std::vector<KindPair> pairs = PairsOf(arguments, subjects);
  for (const Family family :
       FamiliesNamed(arguments.families, AllFamilies(), &FamilyNamed)) {
    for (const auto& [A, B] : pairs) {
      series.emplace_back(QuestionSeries{.family = family,
                                         .A = A,
                                         .B = B,
                                         .seed = arguments.seed.value_or(kSeed),
                                         .first = arguments.first,
                                         .count = arguments.count.value_or(kCount),
                                         .climb = arguments.climb});
    }
  }
  return series;
}

/** Throws InputError if an option chooses generated questions. */
void RefuseGenerated(const SweepArguments& arguments) {
  const char* const option = arguments.families != std::vector<std::string>{"all"}
                                 ? "--family"
                             : arguments.seed      ? "--seed"
                             : arguments.climb > 1 ? "--climb"
                                                   : nullptr;
  if (option == nullptr) return;
  throw InputError(
      fmt::format("{} is for generated questions; expected no such option with --from, "
                  "which asks those of the files",
                  option));
}

/** Reads a file of --from. Throws InputError with its errors. */
std::vector<FileSeries> SeriesOfFile(const std::string& file) {
  FileOfQuestions read = ReadFileSeries(file);
  for (const Diagnostic& note : read.notes)
    std::cerr << "touchstone: " << ToNote(note) << '\n';
  std::vector<std::string> errors;
  for (const Diagnostic& error : read.errors) errors.push_back(ToString(error));
  if (!errors.empty()) throw InputError(fmt::format("{}", fmt::join(errors, "\n")));
  return std::move(read.series);
}

/** Returns the questions of the files of --from that --pair, --first and --count choose.
 Throws InputError if there is none in a file. */
std::vector<Series> SeriesOfFiles(const SweepArguments& arguments) {
  RefuseGenerated(arguments);
  const std::vector<KindPair> pairs = ChosenPairs(arguments);
  std::vector<Series> all;
  std::set<std::string> seen;
  for (const std::string& file : arguments.from) {
    if (!seen.insert(file).second) continue;
    const std::size_t before = all.size();
    std::vector<std::string> has;
    for (FileSeries& series : SeriesOfFile(file)) {
      has.push_back(
          fmt::format("{} of {} {}", series.count, NameOf(series.A), NameOf(series.B)));
      const bool is_chosen =
          pairs.empty() || std::ranges::count(pairs, KindPair(series.A, series.B)) > 0;
      if (!is_chosen || arguments.first >= series.count) continue;
      series.first = arguments.first;
      series.count =
          std::min(series.count - series.first, arguments.count.value_or(series.count));
      all.emplace_back(std::move(series));
    }
    if (all.size() == before) {
      throw InputError(fmt::format(
          "{}: has no question that --pair and --first choose; expected some of its: {}",
          file, fmt::join(has, ", ")));
    }
  }
  return all;
}

std::vector<Series> SeriesOfWorlds(const SweepArguments& arguments) {
  const char* const option = !arguments.from.empty()    ? "--from"
                             : arguments.climb > 1      ? "--climb"
                             : !arguments.pairs.empty() ? "--pair"
                                                        : nullptr;
  if (option != nullptr) {
    throw InputError(
        fmt::format("{} is for contact questions; expected no such option", option));
  }
  if (!arguments.oracles.tolerance.IsZero()) {
    throw InputError(
        "--tolerance is for contact questions; expected no such option (a world claims "
        "its own tolerances)");
  }
  std::vector<Series> series;
  for (const WorldFamily family :
       FamiliesNamed(arguments.families, AllWorldFamilies(), &WorldFamilyNamed)) {
    series.emplace_back(WorldSeries{.family = family,
                                    .seed = arguments.seed.value_or(kSeed),
                                    .first = arguments.first,
                                    .count = arguments.count.value_or(kCount)});
  }
  return series;
}

SweepPlan PlanOf(const Session& session, const SweepArguments& arguments) {
  SweepPlan plan;
  plan.subjects =
      SubjectsNamed(session.registry, arguments.oracles.subject, arguments.kind);
  if (!arguments.oracles.against.empty()) {
    OracleSelection selection = arguments.oracles;
    selection.subject = plan.subjects.front()->info().name;
    const std::vector<const Oracle*> oracles = SelectOracles(session.registry, selection);
    // Laws judge a motion, whatever the references do, so they have no part in the
    // result.
    if (arguments.kind == QuestionKind::kContact)
      plan.references.assign(oracles.begin() + 1, oracles.end());
  }
  if (arguments.kind == QuestionKind::kWorld)
    plan.series = SeriesOfWorlds(arguments);
  else if (!arguments.from.empty())
    plan.series = SeriesOfFiles(arguments);
  else
    plan.series = ContactSeries(arguments, plan.subjects);
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

/** Returns the question of a kept failure, one contact or one world. */
Questions QuestionOf(const std::string& scenario) {
  const ReadResult read = ReadScenario(scenario, "a kept failure");
  Questions question;
  if (read.scenario) question.contacts.push_back(*read.scenario);
  if (read.world) question.worlds.push_back(*read.world);
  return question;
}

const std::string& IdOf(const Questions& question) {
  return question.worlds.empty() ? question.contacts.at(0).id : question.worlds[0].id;
}

/** Returns the comment that says which answer of `subject` failed a question. */
std::string CommentOn(const FailedQuestion& failure, const std::string& subject) {
  const std::string_view unit = UnitOf(failure.kind.measure);
  return Commented(fmt::format("{} fails {}{}{}: {:.3g}{}{} where {:.3g} is allowed. {}",
                               subject, NameOf(failure.kind.measure),
                               failure.kind.law.empty() ? "" : " of the law ",
                               failure.kind.law, failure.value, unit.empty() ? "" : " ",
                               unit, failure.tolerance, failure.proof),
                   "# ");
}

/** Writes the failed questions that the file keeps as scenario files, each with comments
 that say who failed it. Returns their number. */
std::size_t WriteFailures(const OutputFolder& folder, const SweepFile& file) {
  struct Failed {
    std::string comments;
    std::string scenario;
  };
  const std::vector<std::string>& subjects = file.settings().subjects;
  std::size_t count = 0;
  for (std::size_t s = 0; s < file.settings().series.size(); ++s) {
    const bool is_own = subjects.size() > 1 && IsSearch(file.settings().series[s]);
    std::map<std::string, Failed> questions;  // By name.
    const SeriesTally tally = file.Read(s);
    for (std::size_t i = 0; i < tally.oracles.size(); ++i) {
      for (const auto& [kind, failures] : tally.oracles[i].failures) {
        for (const FailedQuestion& failure : failures) {
          const std::string id = IdOf(QuestionOf(failure.scenario));
          const std::string name = is_own ? id + '/' + subjects[i] : id;
          Failed& failed = questions[name];
          failed.comments += CommentOn(failure, subjects[i]);
          // The id of a file is its path.
          failed.scenario = failure.scenario;
          failed.scenario.replace(failed.scenario.find(id), id.size(), name);
        }
      }
    }
    for (const auto& [name, failed] : questions) {
      const std::string text = failed.comments + failed.scenario;
      folder.Write(name + ".toml", [&text](std::ostream& out) { out << text; });
    }
    count += questions.size();
  }
  return count;
}

/** Prints the worst failure of each cluster next to the answers of the references, first
 those of the measures and laws with the most failures. */
void ExplainFailures(const Session& session, const SweepArguments& arguments,
                     const SweepFile& file, const SubjectSummary& subject) {
  constexpr std::size_t kShown = 3;
  OracleSelection selection = arguments.oracles;
  selection.subject = file.settings().subjects.front();
  const std::vector<const Oracle*> oracles = SelectOracles(session.registry, selection);
  // All causes together, since only the first of many failures are examined.
  std::map<std::pair<MeasureKind, std::string_view>, std::uint64_t> failures;
  for (const auto& [kind, cluster] : subject.clusters)
    failures[{kind.measure, kind.law}] += cluster.count;
  struct Ranked {
    const FailureCluster* cluster;
    std::pair<std::uint64_t, std::uint64_t> counts;  // Of the measure, of the cluster.
  };
  std::vector<Ranked> clusters;
  clusters.reserve(subject.clusters.size());
  for (const auto& [kind, cluster] : subject.clusters) {
    // Examined failures of the same measure are shown, with their cause.
    if (cluster.worst && kind.cause != Cause::kNotExamined)
      clusters.push_back({&cluster, {failures[{kind.measure, kind.law}], cluster.count}});
  }
  std::stable_sort(clusters.begin(), clusters.end(),
                   [](const Ranked& a, const Ranked& b) { return a.counts > b.counts; });
  for (std::size_t i = 0; i < clusters.size() && i < kShown; ++i) {
    const FailureCluster& cluster = *clusters[i].cluster;
    const Series& series = file.settings().series[cluster.series];
    const std::uint64_t question = cluster.worst->question;
    RunOptions options;
    options.jobs = arguments.jobs;
    options.partial = true;
    std::cout << '\n' << cluster.worst->scenario << '\n';
    WriteExplanation(Run(QuestionOf(cluster.worst->scenario), oracles, {}, options), {},
                     std::cout);
    std::cout << fmt::format("Repeat with: {} --subject {}\n", ReplayOf(series, question),
                             file.settings().subjects.front());
  }
}

/** Returns the exit code of what was swept, of a part if that is not complete. */
int ExitCodeOf(const Swept& swept, const std::vector<SubjectSummary>& subjects,
               bool all_subjects) {
  const SweepFile& file = swept.file;
  const auto any = [&subjects](auto is_so) {
    return std::any_of(subjects.begin(), subjects.end(), is_so);
  };
  if (any([](const SubjectSummary& s) { return s.fails; })) return 1;
  const auto is_verified = [](const SubjectSummary& s) { return s.examined > 0; };
  // With `all`, nobody has said that each of them supports the questions.
  if (all_subjects && any(is_verified)) return 0;
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    if (is_verified(subjects[i])) continue;
    if (!swept.complete) {
      std::cerr << "touchstone: nothing was verified before it stopped; expected more "
                   "time\n";
      return 2;
    }
    const Series& first = file.settings().series.front();
    std::cerr << fmt::format(
        "touchstone: nothing was verified; expected a {} that {} {}\n",
        IsOfWorlds(first) ? "world"
        : IsOfFile(first) ? "question"
                          : "touching question",
        file.settings().subjects[i], IsOfWorlds(first) ? "simulates" : "supports");
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
  const auto sweep = [&] {
    const Interrupt interrupt(WorkingEngines::kEnd);
    return arguments.out ? SweepInto(*arguments.out, plan, options)
                         : SweepInMemory(plan, options);
  };
  const Swept swept = sweep();
  bar.reset();
  const std::vector<SubjectSummary> subjects =
      PrintSweepTable(swept.file, arguments.fail_above);
  const std::size_t written = out ? WriteFailures(*out, swept.file) : 0;
  const bool is_explained = subjects.size() == 1 && !arguments.quiet && swept.complete &&
                            subjects.front().failed > 0;
  if (is_explained) ExplainFailures(session, arguments, swept.file, subjects.front());
  PrintFailureClusters(swept.file, subjects);
  if (written > 0 && !arguments.quiet) {
    std::cout << fmt::format("{} as files: {}\n", Counted(written, "failed question"),
                             (*arguments.out / "sweep").string());
  }
  if (!swept.complete) {
    std::cout.flush();
    std::cerr << fmt::format(
        "touchstone: stopped after {} of {} blocks; {}\n", swept.file.blocks().size(),
        arguments.shard.SizeOf(BlockCount(plan)),
        arguments.out ? "the same command goes on from there"
                      : "with --out, the same command would go on from there");
    if (const int signal = Interrupt::signal()) return 128 + signal;
  }
  return ExitCodeOf(swept, subjects, arguments.oracles.subject == "all");
} catch (const SweepFileError& error) {
  throw InputError(error.what());
}

}  // namespace touchstone
