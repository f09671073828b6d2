#include "cli/command_line.h"

#include <exception>
#include <functional>
#include <initializer_list>
#include <iostream>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/body_text.h"
#include "cli/choose_setups.h"
#include "cli/command_examples.h"
#include "cli/commands/bench_command.h"
#include "cli/commands/bench_worlds_command.h"
#include "cli/commands/check_oracle_command.h"
#include "cli/commands/explain_command.h"
#include "cli/commands/ledger_command.h"
#include "cli/commands/list_command.h"
#include "cli/commands/merge_command.h"
#include "cli/commands/oracles_command.h"
#include "cli/commands/report_command.h"
#include "cli/commands/reproduce_command.h"
#include "cli/commands/run_command.h"
#include "cli/commands/serve_command.h"
#include "cli/commands/shrink_command.h"
#include "cli/commands/simulate_command.h"
#include "cli/commands/sweep_command.h"
#include "cli/commands/triage_command.h"
#include "cli/expected.h"
#include "cli/external_oracles.h"
#include "cli/input_error.h"
#include "cli/line_error.h"
#include "reports/bench/scene.h"
#include "reports/finding/grade.h"
#include "reports/worlds/study/check_claims.h"
#include "scenarios/schema/scenario_schema.h"

namespace touchstone {
namespace {

constexpr const char* kIntroduction =
    "Checks collision and rigid-body engines against each other and proves which is "
    "right.\n\n"
    "  touchstone run                          run the whole catalogue on every engine\n"
    "  touchstone run contact/box_box          run one group of scenarios\n"
    "  touchstone run mine.toml --out report   run your own scenario, write "
    "report/report.html\n"
    "  touchstone compare yesterday today      say what got worse, exit code 1 if "
    "anything did\n"
    "  touchstone explain contact/zoo/fcl_395  show every answer to one scenario\n"
    "  touchstone ask --A 'box 1 2 3' --B 'sphere 0.5 @ 1.2 0 0'\n"
    "  touchstone sweep contact --pair box box --count 100000\n"
    "  touchstone shrink contact/zoo/fcl_508y --oracle fcl/distance\n"
    "  touchstone reproduce contact/zoo/fcl_508y --for fcl/distance\n"
    "  touchstone simulate world/free --oracles bullet,ode --csv motion.csv\n"
    "  touchstone bench worlds --scene boxes1000\n"
    "  touchstone COMMAND --help               show the options of a command\n\n"
    "Exit code: 0 all pass or known, 1 failures, 2 bad input or nothing of the subject "
    "verified.\n";

const std::string kPatterns =
    "scenario ids, folders of ids, globs (* within a level, ** across levels), or your "
    "own TOML files and folders";

// The parser of the command line: all commands, their options and their actions.
class CommandLine {
 public:
  CommandLine(OracleRegistry registry, const CommandLineDefaults& defaults)
      : session_{std::move(registry), defaults.subject, defaults.data, DetectTerminal()},
        app_(kIntroduction) {
    app_.name("touchstone");
    app_.require_subcommand(1);
    app_.set_version_flag("--version", TOUCHSTONE_VERSION);
    AddRun();
    AddReport();
    AddCompare();
    AddExplain();
    AddAsk();
    AddList();
    AddOracles();
    AddSweep();
    AddMerge();
    AddTriage();
    AddShrink();
    AddReproduce();
    AddBench();
    AddSimulate();
    AddServe();
    AddCheckOracle();
    AddSchema();
    AddLedger();
  }

  int Run(int argc, const char* const* argv) {
    sweep_.slurm.words.assign(argv + 1, argv + argc);
    try {
      app_.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      // --help and --version arrive here too, as successes.
      if (error.get_exit_code() == 0) {
        // The list of commands shows their summaries only, their own --help all.
        for (CLI::App* app : app_.get_subcommands())
          app->description(app->get_description() + DescriptionOf(app->get_name()));
        return app_.exit(error, std::cout, std::cerr);
      }
      std::cerr << "touchstone: " << LineError(app_, error) << '\n';
      return 2;
    }
    try {
      if (asking_.contains(app_.get_subcommands().front()))
        AddExternalOracles(external_, session_.registry);
      GrantTolerance();
      ChooseSetups(setups_, session_.registry);
      const int code = command_();
      // Lost output, e.g. on a full disk, is a failure.
      if (std::cout.flush()) return code;
      std::cerr << "touchstone: the output cannot be written; expected free space at its "
                   "destination\n";
      return 2;
    } catch (const InputError& error) {
      std::cerr << "touchstone: " << error.what() << '\n';
      return 2;
    }
  }

 private:
  CLI::App* AddCommand(const char* name, const char* description,
                       std::function<int()> command) {
    CLI::App* app = app_.add_subcommand(name, description);
    app->footer(ExamplesOf(name));
    app->callback([this, command = std::move(command)] { command_ = command; });
    return app;
  }

  void AddScenarios(CLI::App* app, ScenarioSelection& selection) {
    app->add_option("PATTERN", selection.patterns,
                    kPatterns + " (default: the whole catalogue)")
        ->type_name("");
    selection.catalogues = {session_.catalogue()};
    app->add_option("--catalogue", selection.catalogues,
                    "folder in which scenario ids are looked up")
        ->type_name("DIR")
        ->allow_extra_args(false);
  }

  void AddOracleOptions(CLI::App* app, OracleSelection& selection) {
    selection.subject = session_.default_subject;
    app->add_option("--subject", selection.subject, "oracle under examination")
        ->type_name("ORACLE")
        ->capture_default_str();
    app->add_option("--against", selection.against,
                    "references, e.g. bullet,fcl/collide (default: all other oracles)")
        ->type_name("ORACLE")
        ->delimiter(',')
        ->allow_extra_args(false);
    app->add_option("--tolerance", selection.tolerance.length,
                    "error of contact answers that is granted to the subject beyond "
                    "rounding; the report says so")
        ->check(NotNegative())
        ->type_name("METRES");
    app->add_option("--tolerance-share", selection.tolerance.share,
                    "the same as a fraction of the size of the scene")
        ->check(NotNegative())
        ->type_name("SHARE");
    AddExternal(app);
  }

  /** Grants the subject the tolerance of the options, if one is given. */
  void GrantTolerance() {
    for (OracleSelection* selection :
         {&run_.oracles, &ask_.oracles, &sweep_.oracles, &ledger_.oracles, &oracles_}) {
      StatedTolerance& tolerance = selection->tolerance;
      if (tolerance.IsZero()) continue;
      tolerance.by = tolerance.share == 0    ? "--tolerance"
                     : tolerance.length == 0 ? "--tolerance-share"
                                             : "--tolerance and --tolerance-share";
      for (const Oracle* subject :
           SubjectsNamed(session_.registry, selection->subject, QuestionKind::kContact)) {
        session_.registry.SetTolerance(subject->info().name, tolerance);
      }
    }
  }

  void AddSet(CLI::App* app) {
    app->add_option("--set", setups_.set,
                    "setting of an engine in worlds, e.g. ode:contact_erp=0.2; may be "
                    "repeated (`touchstone oracles --settings` lists them)")
        ->type_name("ORACLE:NAME=VALUE")
        ->allow_extra_args(false);
  }

  void AddSetups(CLI::App* app) {
    AddSet(app);
    app->add_flag("--as-shipped", setups_.as_shipped,
                  "simulate worlds with the default settings of every engine");
  }

  static void AddJobs(CLI::App* app, int& jobs) {
    app->add_option("--jobs", jobs, "number of threads (default: one per core)")
        ->check(WholeNumber(1, std::numeric_limits<int>::max()))
        ->type_name("N");
  }

  /** Adds the options for oracles that are programs of their own. */
  void AddExternal(CLI::App* app) {
    asking_.insert(app);
    app->add_option("--oracle", external_.commands,
                    "a program that speaks the oracle protocol, as one more oracle; may "
                    "be repeated")
        ->type_name("NAME=COMMAND")
        ->allow_extra_args(false);
    app->add_option("--oracles", external_.file,
                    fmt::format("file of such programs (default: {} in the working "
                                "folder, if it exists)",
                                kOraclesFile))
        ->type_name("FILE");
  }

  // A list of oracles. Programs may be among the names that --oracle gives, and a file of
  // programs among those of --oracles.
  CLI::Option* AddOracleList(CLI::App* app, std::vector<std::string>& oracles) {
    asking_.insert(app);
    app->add_option_function<std::vector<std::string>>(
           "--oracle",
           [this, &oracles](const std::vector<std::string>& texts) {
             for (const std::string& text : texts) {
               if (IsProgram(text)) {
                 external_.commands.push_back(text);
                 continue;
               }
               std::istringstream names(text);
               for (std::string name; std::getline(names, name, ',');)
                 oracles.push_back(name);
             }
           },
           "an oracle of --oracles, or a program that speaks the oracle protocol as one "
           "more; may be repeated")
        ->type_name("ORACLE|NAME=COMMAND")
        ->allow_extra_args(false)
        ->trigger_on_parse(false);
    return app
        ->add_option_function<std::vector<std::string>>(
            "--oracles",
            [this, &oracles](const std::vector<std::string>& texts) {
              for (const std::string& text : texts) {
                if (text.ends_with(".toml"))
                  external_.file = text;
                else
                  oracles.push_back(text);
              }
            },
            "oracles, e.g. cookbook,bullet (default: all); or a file of programs, "
            "mine.toml")
        ->type_name("ORACLE")
        ->delimiter(',')
        ->allow_extra_args(false);
  }

  static bool IsProgram(const std::string& text) {
    return text.find('=') != std::string::npos;
  }

  // A number of questions, an index or a seed.
  static void AddNumber(CLI::App* app, const char* name, std::uint64_t& number,
                        std::uint64_t least, const char* description,
                        std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) {
    app->add_option(name, number, description)
        ->check(WholeNumber(least, most))
        ->type_name("N")
        ->capture_default_str();
  }

  void AddRun() {
    CLI::App* app = AddCommand("run", "Run scenarios on oracles and judge the answers",
                               [this] { return RunCommand(session_, run_); });
    AddScenarios(app, run_.scenarios);
    AddOracleOptions(app, run_.oracles);
    AddSetups(app);
    app->add_option("--out", run_.out,
                    "folder for report.html, report.data, report.jsonl and junit.xml; "
                    "until they are written it keeps every world that has been judged")
        ->type_name("DIR");
    app->add_flag("--resume", run_.resume,
                  "go on with a run that was interrupted: use the worlds that DIR keeps")
        ->needs("--out");
    app->add_flag(
        "--open", run_.open,
        "show the page in the browser (without --out, from touchstone-report/)");
    app->add_option("--ledger", run_.ledger,
                    "ledger of known discrepancies (default: the built-in ledger)")
        ->type_name("FILE");
    app->add_option("--baseline", run_.baseline,
                    "report.jsonl of an earlier run: a finding with a worse verdict or "
                    "twice its error fails this run")
        ->type_name("FILE");
    app->add_option("--audit", run_.audit,
                    "docs/accuracy.md: errors that are not those of its table, and a "
                    "ledger that `ledger --audit` finds not in order, fail this run")
        ->type_name("FILE");
    app->add_option_function<std::string>(
           "--fail-on",
           [this](const std::string& whose) {
             run_.rule.whose = whose == "subject"  ? FailOn::kSubject
                               : whose == "faults" ? FailOn::kFaults
                                                   : FailOn::kAnything;
           },
           "failures that give exit code 1: subject (for your own CI), those of the "
           "subject; faults (default), also those of references unless they are "
           "rounding; "
           "anything, all")
        ->check(OneOf({"subject", "faults", "anything"}))
        ->type_name("SCOPE");
    AddFailAbove(app, run_.rule.above);
    AddJobs(app, run_.jobs);
    app->add_flag("--timings", run_.timings,
                  "print the twenty longest answers and worlds, and the sums by oracle, "
                  "kind of motion, law and kind of contact query");
    app->add_flag("--quiet", run_.quiet,
                  "print only the failures that count and the last line");
  }

  void AddReport() {
    CLI::App* app =
        AddCommand("report", "Write the page of an earlier run, or of a sweep",
                   [this] { return ReportCommand(session_, report_); });
    app->add_option(
           "RUN", report_.run,
           "folder that `touchstone run --out` or `touchstone sweep --out` wrote, "
           "or its report.data or sweep.sqlite")
        ->required()
        ->type_name("");
    app->add_option("-o,--out", report_.out, "the page")->required()->type_name("FILE");
    AddJobs(app, report_.jobs);
  }

  void AddCompare() {
    CLI::App* app = AddCommand("compare", "Say what changed from one run to another",
                               [this] { return CompareCommand(compare_); });
    app->add_option("OLD", compare_.before,
                    "folder that `touchstone run --out` wrote, or its report.data")
        ->required()
        ->type_name("");
    app->add_option("NEW", compare_.after,
                    "the same of the later run; not needed with --oracle")
        ->type_name("");
    app->add_option("--oracle", compare_.oracle,
                    "compare this oracle, e.g. a version of an engine, …")
        ->type_name("ORACLE");
    app->add_option("--with", compare_.with, "… with this one, in the same run or in NEW")
        ->type_name("ORACLE");
    app->add_option("--json", compare_.json, "file for all changes as JSON")
        ->type_name("FILE");
    app->add_option("--junit", compare_.junit, "file for all changes as JUnit XML")
        ->type_name("FILE");
    app->add_option("--html", compare_.html, "file for the page of NEW with all changes")
        ->type_name("FILE");
  }

  void AddExplain() {
    CLI::App* app = AddCommand(
        "explain", "Show every oracle's answer to a scenario, with proofs",
        [this] { return ExplainCommand(session_, explained_, oracles_, everything_); });
    AddScenarios(app, explained_);
    app->get_option("PATTERN")->required()->description(kPatterns);
    AddOracleOptions(app, oracles_);
    AddSetups(app);
    app->add_flag(
        "--all", everything_,
        "print the scenario file, and every contact and number of every oracle");
  }

  void AddAsk() {
    CLI::App* app = AddCommand("ask", "Query every oracle about two given shapes",
                               [this] { return AskCommand(session_, ask_); });
    app->footer("A BODY is " + std::string(kBodySyntax) + "\n\n" + ExamplesOf("ask"));
    app->add_option("--A,-A", ask_.A, "first body")->required()->type_name("BODY");
    app->add_option("--B,-B", ask_.B, "second body")->required()->type_name("BODY");
    AddOracleOptions(app, ask_.oracles);
    app->add_flag("--toml", ask_.toml,
                  "print the question as a scenario file and query no oracle");
    app->add_flag("--all", ask_.everything,
                  "print every contact, number and proof of every oracle");
    app->add_option("--id", ask_.id,
                    "id of the scenario; in a folder of scenarios, the path below it")
        ->capture_default_str();
  }

  void AddList() {
    CLI::App* app = AddCommand("list", "List ids and titles of scenarios",
                               [this] { return ListCommand(listed_); });
    AddScenarios(app, listed_);
  }

  void AddOracles() {
    CLI::App* app = AddCommand("oracles", "List the oracles and their capabilities",
                               [this] { return OraclesCommand(session_, settings_); });
    AddExternal(app);
    app->add_flag("--settings", settings_,
                  "print the settings and conversions of each adapter instead, and those "
                  "that --set chooses");
  }

  static std::vector<std::string> ShapeNames() {
    std::vector<std::string> names;
    names.reserve(kShapeKinds);
    for (int kind = 0; kind < kShapeKinds; ++kind)
      names.emplace_back(NameOf(static_cast<ShapeKind>(kind)));
    return names;
  }

  static void AddPair(CLI::App* app, std::vector<std::string>& pair) {
    app->add_option("--pair", pair, "two shapes, e.g. --pair box sphere")
        ->check(OneOf(ShapeNames()))
        ->type_name("SHAPE SHAPE")
        ->expected(2);
  }

  void AddSweep() {
    CLI::App* app = AddCommand(
        "sweep", "Check the subject on thousands of generated questions, or yours",
        [this] { return SweepCommand(session_, sweep_); });
    app->add_option_function<std::string>(
           "QUESTIONS",
           [this](const std::string& kind) {
             sweep_.kind =
                 kind == "world" ? QuestionKind::kWorld : QuestionKind::kContact;
           },
           "kind of question: contact or world")
        ->required()
        ->check(OneOf({"contact", "world"}))
        ->type_name("");
    AddOracleOptions(app, sweep_.oracles);
    app->get_option("--subject")
        ->description(
            "oracles under examination, e.g. cookbook or ode,fcl; all: every oracle")
        ->type_name("ORACLE[,...]");
    app->get_option("--against")
        ->description(
            "references that answer every contact question too (default: none); they, or "
            "all others, answer the failures that are printed");
    app->add_option(
           "--family", sweep_.families,
           "families of contact questions: random, near_parallel, edge_edge, "
           "vertex_face, touching, deep, slabs_and_needles, extreme_scales, symmetries, "
           "grazing, mixed_sizes, far_from_origin, large_hulls; of worlds: drops, "
           "impacts, slides, rods, stacks, mass_ratios, step_lengths, linkages, bars; or "
           "all")
        ->type_name("FAMILY")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->capture_default_str();
    app->add_option("--pair", sweep_.pairs,
                    "two shapes of a contact question, e.g. --pair box sphere; may be "
                    "repeated (default: all pairs that a subject supports, each in "
                    "one order, as the other is a variant; or those of a file)")
        ->check(OneOf(ShapeNames()))
        ->type_name("SHAPE SHAPE")
        ->allow_extra_args(false);
    // SQLite has signed numbers.
    constexpr auto kMost = std::uint64_t{1} << 62;
    app->add_option(
           "--from", sweep_.from,
           "ask the contact questions of these files instead of generated ones: "
           "a table of poses (*.csv, docs/contact_table.md), the report.jsonl of "
           "a run, a scenario file or a folder of them")
        ->type_name("FILE");
    app->add_option("--count", sweep_.count,
                    "number of questions per family or file, and per pair of shapes "
                    "(default: 200 of a family, all of a file)")
        ->check(WholeNumber(1, kMost))
        ->type_name("N");
    AddNumber(app, "--first", sweep_.first, 0, "index of the first question", kMost);
    app->add_option("--seed", sweep_.seed, "seed of the questions (default: 1)")
        ->check(WholeNumber(0, std::numeric_limits<std::uint64_t>::max()))
        ->type_name("N");
    app->add_option(
           "--climb", sweep_.climb,
           "worst-case search: of every N contact questions the first is one of the "
           "family, each other the worst so far with B changed a little "
           "(default: 1, no search)")
        ->check(WholeNumber(1, 1'000'000))
        ->type_name("N");
    app->add_option("--out", sweep_.out,
                    "folder for sweep.sqlite, and for failed questions as TOML files; a "
                    "sweep that was interrupted goes on")
        ->type_name("DIR");
    app->add_option_function<std::string>(
           "--shard",
           [this](const std::string& text) {
             const auto [part, whole] = PartOf(text);
             sweep_.shard = {part - 1, whole};
           },
           "ask only part K of N of the questions; `touchstone merge` joins the parts")
        ->check(PartOfWhole())
        ->type_name("K/N");
    app->add_option_function<std::string>(
           "--time", [this](const std::string& text) { sweep_.time = DurationOf(text); },
           "stop after that time, e.g. 90s, 10m or 2h")
        ->check(Duration())
        ->type_name("TIME");
    AddFailAbove(app, sweep_.fail_above);
    AddSetups(app);
    AddSlurm(app);
    AddJobs(app, sweep_.jobs);
    app->add_flag("--quiet", sweep_.quiet, "print only the tables");
  }

  void AddSlurm(CLI::App* app) {
    app->add_flag(
        "--slurm", sweep_.slurm.submit,
        "submit the sweep to a Slurm cluster, a job array and a merge; with the "
        "same command again, only what is missing");
    app->add_option("--tasks", sweep_.slurm.tasks,
                    "number of shards on the cluster (default: 16, or one per block)")
        ->check(WholeNumber(2, 1000))
        ->type_name("N");
    app->add_option("--sbatch-args", sweep_.slurm.sbatch_args,
                    "options of sbatch for every job, e.g. '--partition=short --time=60'")
        ->type_name("ARGS");
    app->add_flag("--status", sweep_.slurm.status,
                  "with --slurm: show the progress of each shard, submit nothing");
  }

  /** Adds the grade above which failures give exit code 1. */
  static void AddFailAbove(CLI::App* app, Grade& above) {
    app->add_option_function<std::string>(
           "--fail-above",
           [&above](const std::string& size) {
             above = size == "touching" ? Grade::kGross : GradeOfShare(std::stod(size));
           },
           "failures up to that share of the smaller body do not give exit code 1: 1e-6, "
           "1e-3 or 0.1; with touching, only wrong hits and misses and unusable answers "
           "do")
        ->check(OneOf({"1e-6", "1e-3", "0.1", "touching"}))
        ->type_name("GRADE");
  }

  void AddTriage() {
    CLI::App* app =
        AddCommand("triage", "Find the root causes of the failures of a sweep or run",
                   [this] { return TriageCommand(session_, triage_); });
    app->add_option("DIR", triage_.source,
                    "folder that `touchstone sweep --out` or `touchstone run --out` "
                    "wrote, or its sweep.sqlite or report.data")
        ->required()
        ->type_name("");
    app->add_option("-o,--out", triage_.out,
                    "folder for index.md and a folder a root cause (default: triage, "
                    "in DIR)")
        ->type_name("DIR");
    app->add_option("--subject", triage_.subjects,
                    "only the failures of these oracles or groups, separated by commas")
        ->type_name("NAMES");
    app->add_option("--baseline", triage_.baseline,
                    "folder of an earlier triage: what it has is not new")
        ->type_name("DIR");
    app->add_option("--tries", triage_.tries, "most questions asked to shrink a failure")
        ->check(WholeNumber(1, 1'000'000))
        ->type_name("N")
        ->capture_default_str();
    app->add_option_function<std::string>(
           "--time", [this](const std::string& text) { triage_.time = DurationOf(text); },
           "examine no further kind of failure after that time, e.g. 90s, 10m or 2h")
        ->check(Duration())
        ->type_name("TIME");
    app->add_flag_callback(
        "--no-programs", [this] { triage_.run_programs = false; },
        "do not build and run the programs against the libraries' own API");
    AddExternal(app);
    AddSetups(app);
    AddJobs(app, triage_.jobs);
    app->add_flag("--quiet", triage_.quiet, "show no progress");
  }

  void AddMerge() {
    CLI::App* app = AddCommand("merge", "Join the shards of a sweep",
                               [this] { return MergeCommand(merge_); });
    app->add_option("FILE", merge_.parts,
                    "files that `touchstone sweep --shard K/N --out DIR` wrote, of all K")
        ->required()
        ->type_name("");
    app->add_option("-o,--out", merge_.out, "the file of the whole sweep")
        ->required()
        ->type_name("FILE");
  }

  void AddBench() {
    CLI::App* app = AddCommand("bench", "Measure the speed and accuracy of oracles",
                               [this] { return Bench(); });
    app->add_option("QUESTIONS", benched_, "kind of question: contact or worlds")
        ->required()
        ->check(OneOf({"contact", "worlds"}))
        ->type_name("");
    AddOracleList(app, bench_.oracles);
    AddSet(app);
    AddPair(app, bench_.pair);
    AddNumber(app, "--count", bench_.questions.count, 1,
              "contact: number of random poses per pair");
    AddNumber(app, "--sample", bench_.questions.sample, 0,
              "contact: number of poses checked against the truth");
    AddNumber(app, "--seed", bench_.questions.seed, 0, "seed of the poses");
    app->add_option("--scene", bench_worlds_.scenes,
                    "worlds: boxes100, boxes1000, boxes10000, boxes30000, stack20, "
                    "spheres10000 (default: all)")
        ->check(OneOf(SceneNames()))
        ->type_name("SCENE")
        ->delimiter(',')
        ->allow_extra_args(false);
    app->add_option("--steps", bench_worlds_.turns.steps,
                    "worlds: number of timed steps, after as many to settle")
        ->check(WholeNumber(1, 1'000'000))
        ->type_name("N")
        ->capture_default_str();
    app->add_option("--seconds", bench_worlds_.turns.seconds,
                    "worlds: limit of CPU seconds per engine, scene and thread")
        ->check(WholeNumber(1, 1'000'000))
        ->type_name("N")
        ->capture_default_str();
    app->add_option("--threads", bench_worlds_.turns.threads,
                    "worlds: also time cookbook with N threads; all times are then wall "
                    "times and need an idle machine")
        ->check(NumberOfThreads())
        ->type_name("N")
        ->capture_default_str();
  }

  /** Throws if one of the options `names` is given: they belong to the other kind. */
  void RefuseBenchOptions(std::initializer_list<const char*> names) const {
    for (const char* name : names) {
      if (app_.get_subcommand("bench")->get_option(name)->empty()) continue;
      throw InputError(
          fmt::format("{} is not an option of `bench {}`; expected it with {}", name,
                      benched_, benched_ == "contact" ? "worlds" : "contact"));
    }
  }

  int Bench() {
    if (benched_ == "contact") {
      RefuseBenchOptions({"--scene", "--steps", "--seconds", "--threads", "--set"});
      return BenchCommand(session_, bench_);
    }
    RefuseBenchOptions({"--pair", "--count", "--sample"});
    bench_worlds_.oracles = bench_.oracles;
    bench_worlds_.seed = bench_.questions.seed;
    return BenchWorldsCommand(session_, bench_worlds_);
  }

  void AddSimulate() {
    CLI::App* app = AddCommand("simulate", "Simulate worlds and write the motion as CSV",
                               [this] { return SimulateCommand(session_, simulate_); });
    AddScenarios(app, simulate_.scenarios);
    app->get_option("PATTERN")->required()->description(kPatterns);
    AddOracleList(app, simulate_.oracles)
        ->description(
            "oracles, e.g. cookbook,bullet (default: all that simulate worlds); or a "
            "file "
            "of programs, mine.toml");
    AddSetups(app);
    app->add_option("--csv", simulate_.csv,
                    "file for the table, - for standard output (default: -)")
        ->type_name("FILE");
  }

  void AddFault(CLI::App* app, FaultSelection& fault) {
    AddScenarios(app, fault.scenarios);
    app->get_option("PATTERN")->required()->description(
        "a scenario id, or your own TOML file");
    AddExternal(app);
    app->remove_option(app->get_option("--oracle"));
    app->add_option_function<std::vector<std::string>>(
           "--oracle,--for",
           [this, &fault](const std::vector<std::string>& texts) {
             for (const std::string& text : texts) {
               if (IsProgram(text))
                 external_.commands.push_back(text);
               else
                 fault.oracle = text;
             }
           },
           "oracle whose fault it is (default: the only one that is wrong); or a program "
           "that speaks the oracle protocol, as one more oracle")
        ->type_name("ORACLE|NAME=COMMAND")
        ->allow_extra_args(false);
    app->add_option("--measure", fault.measure,
                    "measure that finds it, e.g. separation_error (default: the simplest "
                    "proof of the gravest fault)")
        ->type_name("MEASURE");
    app->add_option("--keep", fault.keep,
                    "the same with a size, e.g. 'separation_error > 0.1'")
        ->type_name("'MEASURE > NUMBER'")
        ->excludes("--measure");
  }

  void AddShrink() {
    CLI::App* app = AddCommand("shrink", "Find the smallest question with a fault",
                               [this] { return ShrinkCommand(session_, shrink_); });
    AddFault(app, shrink_.fault);
    AddNumber(app, "--tries", shrink_.tries, 1, "most smaller questions to ask");
    app->add_option("--out", shrink_.out,
                    "file for the scenario (default: standard output)")
        ->type_name("FILE");
    app->add_flag("--quiet", shrink_.quiet, "print nothing with --out");
  }

  void AddReproduce() {
    CLI::App* app =
        AddCommand("reproduce", "Write a program that shows a fault without Touchstone",
                   [this] { return ReproduceCommand(session_, reproduce_); });
    AddFault(app, reproduce_.fault);
    app->add_option("--out", reproduce_.out,
                    "folder for reproduce.cc, CMakeLists.txt and REPORT.md")
        ->type_name("DIR")
        ->capture_default_str();
  }

  void AddLedger() {
    CLI::App* app =
        AddCommand("ledger", "Propose, bound or audit the known discrepancies",
                   [this] { return LedgerCommand(session_, ledger_); });
    AddScenarios(app, ledger_.scenarios);
    AddOracleOptions(app, ledger_.oracles);
    app->add_option("--ledger", ledger_.ledger,
                    "ledger of what is known already (default: the built-in ledger)")
        ->type_name("FILE");
    auto* action = app->add_option_group("action");
    const auto add = [&](const char* name, LedgerAction what, const char* description) {
      action->add_flag_callback(
          name, [this, what] { ledger_.action = what; }, description);
    };
    add("--propose", LedgerAction::kPropose,
        "print entries for failures that no entry covers, for a person to complete");
    add("--update", LedgerAction::kUpdate,
        "write the bounds of all findings that an entry covers to the file next to the "
        "ledger, FILE.bounds");
    add("--audit", LedgerAction::kAudit,
        "print how large an error the ledger could hide, and what it hides");
    action->require_option(1);
    app->add_flag("--causes", ledger_.causes,
                  "with --update: also write the causes that were found into the ledger")
        ->needs("--update");
    AddCommand("accuracy", "Print docs/accuracy.md, the worst error of each oracle",
               [this] { return AccuracyCommand(session_); });
  }

  void AddServe() {
    CLI::App* app =
        AddCommand("serve", "Answer the oracle protocol for one of the oracles",
                   [this] { return ServeCommand(session_, served_); });
    app->add_option("ORACLE", served_, "name of the oracle")->required()->type_name("");
  }

  void AddCheckOracle() {
    CLI::App* app =
        AddCommand("check-oracle", "Say what is wrong with a program as an oracle",
                   [this] { return CheckOracleCommand(session_, checked_); });
    app->add_option("COMMAND", checked_,
                    "the program and its arguments, after --; or the name of an oracle")
        ->required()
        ->type_name("");
  }

  void AddSchema() {
    AddCommand("schema", "Print the JSON Schema of scenario files", [] {
      std::cout << ScenarioSchema(ClaimNames());
      return 0;
    });
  }

  Session session_;
  CLI::App app_;
  std::function<int()> command_;
  std::set<const CLI::App*> asking_;  ///< The commands that ask oracles.
  ExternalOracleArguments external_;
  std::string served_;
  std::vector<std::string> checked_;
  SetupArguments setups_;
  RunArguments run_;
  ReportArguments report_;
  CompareArguments compare_;
  AskArguments ask_;
  SweepArguments sweep_;
  MergeArguments merge_;
  TriageArguments triage_;
  LedgerArguments ledger_;
  BenchArguments bench_;
  BenchWorldsArguments bench_worlds_;
  std::string benched_;
  ShrinkArguments shrink_;
  ReproduceArguments reproduce_;
  SimulateArguments simulate_;
  ScenarioSelection explained_;
  OracleSelection oracles_;
  ScenarioSelection listed_;
  bool everything_ = false;
  bool settings_ = false;
};

}  // namespace

int RunCommandLine(int argc, const char* const* argv, OracleRegistry registry,
                   const CommandLineDefaults& defaults) {
  return CommandLine(std::move(registry), defaults).Run(argc, argv);
}

}  // namespace touchstone
