#include "cli/command_line.h"

#include <exception>
#include <functional>
#include <initializer_list>
#include <iostream>
#include <limits>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/commands/bench_command.h"
#include "cli/commands/bench_worlds_command.h"
#include "cli/body_text.h"
#include "cli/command_examples.h"
#include "cli/expected.h"
#include "cli/commands/explain_command.h"
#include "cli/input_error.h"
#include "cli/commands/ledger_command.h"
#include "cli/line_error.h"
#include "cli/commands/list_command.h"
#include "cli/commands/oracles_command.h"
#include "cli/commands/run_command.h"
#include "cli/commands/simulate_command.h"
#include "cli/commands/sweep_command.h"
#include "scenarios/schema/scenario_schema.h"

namespace touchstone {
namespace {

constexpr const char* kIntroduction =
    "Tells collision engines who is right, with a proof.\n\n"
    "  touchstone run                          the whole catalogue, every engine\n"
    "  touchstone run contact/box_box          one group; --subject fcl/collide: another "
    "subject\n"
    "  touchstone run mine.toml --out report   your own scenario; a page in "
    "report/index.html\n"
    "  touchstone explain contact/zoo/fcl_395  every answer to one scenario, side by "
    "side\n"
    "  touchstone ask --A 'box 1 2 3' --B 'sphere 0.5 @ 1.2 0 0'\n"
    "  touchstone sweep contact --pair box box --count 100000\n"
    "  touchstone simulate world/free --oracles bullet,ode --csv motion.csv\n"
    "  touchstone bench worlds --scene boxes1000\n"
    "  touchstone COMMAND --help               what a command takes\n\n"
    "Exit code: 0 all pass or known, 1 failures, 2 bad input or nothing of the subject "
    "verified.";

const std::string kPatterns =
    "scenario ids, folders of ids, globs (* within a level, ** across), or TOML files "
    "and folders of your own";

// The commands, their options, and what they do once the line is parsed.
class CommandLine {
 public:
  CommandLine(OracleRegistry registry, const CommandLineDefaults& defaults)
      : session_{std::move(registry), defaults, DetectTerminal()}, app_(kIntroduction) {
    app_.name("touchstone");
    app_.require_subcommand(1);
    app_.set_version_flag("--version", TOUCHSTONE_VERSION);
    AddRun();
    AddExplain();
    AddAsk();
    AddList();
    AddOracles();
    AddSweep();
    AddBench();
    AddSimulate();
    AddSchema();
    AddLedger();
  }

  int Run(int argc, const char* const* argv) {
    try {
      app_.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      // --help and --version arrive here too, as successes.
      if (error.get_exit_code() == 0) return app_.exit(error, std::cout, std::cerr);
      std::cerr << "touchstone: " << LineError(app_, error) << '\n';
      return 2;
    }
    try {
      const int code = command_();
      // What nobody can read was not told: a full disk is no success.
      if (std::cout.flush()) return code;
      std::cerr << "touchstone: the output cannot be written; expected room for it where "
                   "it goes\n";
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
                    kPatterns + "; all of the catalogue without any")
        ->type_name("");
    selection.catalogues = {session_.catalogue()};
    app->add_option("--catalogue", selection.catalogues, "where ids are looked up")
        ->type_name("DIR")
        ->allow_extra_args(false);
  }

  void AddOracleOptions(CLI::App* app, OracleSelection& selection) {
    selection.subject = session_.defaults.subject;
    app->add_option("--subject", selection.subject, "the oracle under examination")
        ->type_name("ORACLE")
        ->capture_default_str();
    app->add_option("--against", selection.against,
                    "the references, e.g. bullet,fcl/collide; all others without it")
        ->type_name("ORACLE")
        ->delimiter(',')
        ->allow_extra_args(false);
  }

  static void AddJobs(CLI::App* app, int& jobs) {
    app->add_option("--jobs", jobs, "threads; one a core without it")
        ->check(WholeNumber(1, std::numeric_limits<int>::max()))
        ->type_name("N");
  }

  static CLI::Option* AddOracleList(CLI::App* app, std::vector<std::string>& oracles) {
    return app
        ->add_option("--oracles,--oracle", oracles,
                     "e.g. cookbook,bullet; all without it")
        ->type_name("ORACLE")
        ->delimiter(',')
        ->allow_extra_args(false);
  }

  // A number of questions, an index or a seed.
  static void AddNumber(CLI::App* app, const char* name, std::uint64_t& number,
                        std::uint64_t least, const char* description) {
    app->add_option(name, number, description)
        ->check(WholeNumber(least))
        ->type_name("N")
        ->capture_default_str();
  }

  void AddRun() {
    CLI::App* app = AddCommand("run", "put scenarios to oracles and judge the answers",
                               [this] { return RunCommand(session_, run_); });
    AddScenarios(app, run_.scenarios);
    AddOracleOptions(app, run_.oracles);
    app->add_option("--out", run_.out,
                    "write index.html, report.json and junit.xml there")
        ->type_name("DIR");
    app->add_option("--ledger", run_.ledger,
                    "known discrepancies, instead of the built-in")
        ->type_name("FILE");
    app->add_option_function<std::string>(
           "--fail-on",
           [this](const std::string& whose) {
             run_.fail_on = whose == "subject" ? FailOn::kSubject : FailOn::kAnything;
           },
           "whose failures give exit code 1: anything (default: a reference proved wrong "
           "outside the ledger counts too), or subject (what your own CI wants)")
        ->check(OneOf({"subject", "anything"}))
        ->type_name("WHOSE");
    AddJobs(app, run_.jobs);
    app->add_flag("--quiet", run_.quiet,
                  "only the failures that count, and the last line");
  }

  void AddExplain() {
    CLI::App* app = AddCommand(
        "explain", "every oracle's answer to a scenario, side by side, with the proofs",
        [this] { return ExplainCommand(session_, explained_, oracles_, everything_); });
    AddScenarios(app, explained_);
    app->get_option("PATTERN")->required()->description(kPatterns);
    AddOracleOptions(app, oracles_);
    app->add_flag("--all", everything_,
                  "the scenario's file, every contact and every number of everybody");
  }

  void AddAsk() {
    CLI::App* app = AddCommand("ask", "ask everybody about two shapes given here",
                               [this] { return AskCommand(session_, ask_); });
    app->footer("A body is " + std::string(kBodySyntax) + "\n\n" + ExamplesOf("ask"));
    app->add_option("--A,-A", ask_.A, "the first body")->required()->type_name("BODY");
    app->add_option("--B,-B", ask_.B, "the second body")->required()->type_name("BODY");
    AddOracleOptions(app, ask_.oracles);
    app->add_flag("--toml", ask_.toml,
                  "ask nobody: print the question as a scenario file to keep");
    app->add_flag("--all", ask_.everything, "every contact and every proof of everybody");
    app->add_option("--id", ask_.id, "the scenario's id, in a folder its path there")
        ->capture_default_str();
  }

  void AddList() {
    CLI::App* app = AddCommand("list", "ids and titles of the scenarios",
                               [this] { return ListCommand(listed_); });
    AddScenarios(app, listed_);
  }

  void AddOracles() {
    CLI::App* app =
        AddCommand("oracles", "who can answer what, and what is not installed",
                   [this] { return OraclesCommand(session_, settings_); });
    app->add_flag("--settings", settings_, "what each adapter sets and converts");
  }

  // Worlds have no sweep yet: the kind of question is an argument.
  static void AddContact(CLI::App* app) {
    app->add_option("QUESTIONS", "the kind of question: contact")
        ->required()
        ->check(OneOf({"contact"}))
        ->type_name("");
  }

  static void AddPair(CLI::App* app, std::vector<std::string>& pair) {
    app->add_option("--pair", pair, "two shapes, e.g. --pair box sphere; all without it")
        ->type_name("SHAPE SHAPE")
        ->expected(2);
  }

  void AddSweep() {
    CLI::App* app =
        AddCommand("sweep", "generated questions by the thousand, with a seed",
                   [this] { return SweepCommand(session_, sweep_); });
    AddContact(app);
    AddOracleOptions(app, sweep_.oracles);
    app->add_option("--family", sweep_.family,
                    "random, near_parallel, edge_edge, vertex_face, touching, deep, "
                    "slabs_and_needles, extreme_scales, symmetries or all")
        ->type_name("FAMILY")
        ->capture_default_str();
    AddPair(app, sweep_.pair);
    AddNumber(app, "--count", sweep_.count, 1, "questions per family and pair");
    AddNumber(app, "--first", sweep_.first, 0, "index of the first question");
    AddNumber(app, "--seed", sweep_.seed, 0, "another seed, other questions");
    app->add_option("--out", sweep_.out,
                    "write the first failed questions there, as TOML")
        ->type_name("DIR");
    AddJobs(app, sweep_.jobs);
    app->add_flag("--quiet", sweep_.quiet, "only the table");
  }

  void AddBench() {
    CLI::App* app = AddCommand("bench", "time of a query beside its accuracy",
                               [this] { return Bench(); });
    app->add_option("QUESTIONS", benched_, "the kind of question: contact or worlds")
        ->required()
        ->check(OneOf({"contact", "worlds"}))
        ->type_name("");
    AddOracleList(app, bench_.oracles);
    AddPair(app, bench_.pair);
    AddNumber(app, "--count", bench_.count, 1, "of contact: random poses per pair");
    AddNumber(app, "--sample", bench_.sample, 0,
              "of contact: how many of them are held against the truth");
    AddNumber(app, "--seed", bench_.seed, 0, "another seed, other poses");
    app->add_option("--scene", bench_worlds_.scenes,
                    "of worlds: boxes100, boxes1000, boxes10000, boxes30000, stack20, "
                    "spheres10000; all without it")
        ->check(OneOf(SceneNames()))
        ->type_name("SCENE")
        ->delimiter(',')
        ->allow_extra_args(false);
    app->add_option("--steps", bench_worlds_.steps,
                    "of worlds: steps that are timed, after as many to settle")
        ->check(WholeNumber(1, 1'000'000))
        ->type_name("N")
        ->capture_default_str();
    app->add_option("--seconds", bench_worlds_.seconds,
                    "of worlds: CPU time after which an engine is stopped in a scene; "
                    "so much for each of its threads")
        ->check(WholeNumber(1, 1'000'000))
        ->type_name("N")
        ->capture_default_str();
    app->add_option("--threads", bench_worlds_.threads,
                    "of worlds: step cookbook also with so many, in a row of its own; "
                    "then all times are wall times, of a machine that does nothing else")
        ->check(NumberOfThreads())
        ->type_name("N")
        ->capture_default_str();
  }

  /** Refuses an option that says nothing about what is asked. */
  void RefuseBenchOptions(std::initializer_list<const char*> names) const {
    for (const char* name : names) {
      if (app_.get_subcommand("bench")->get_option(name)->empty()) continue;
      throw InputError(fmt::format("{} is no option of `bench {}`; expected it with {}",
                                   name, benched_,
                                   benched_ == "contact" ? "worlds" : "contact"));
    }
  }

  int Bench() {
    if (benched_ == "contact") {
      RefuseBenchOptions({"--scene", "--steps", "--seconds", "--threads"});
      return BenchCommand(session_, bench_);
    }
    RefuseBenchOptions({"--pair", "--count", "--sample"});
    bench_worlds_.oracles = bench_.oracles;
    bench_worlds_.seed = bench_.seed;
    return BenchWorldsCommand(session_, bench_worlds_);
  }

  void AddSimulate() {
    CLI::App* app = AddCommand("simulate", "the motion of worlds, as a table",
                               [this] { return SimulateCommand(session_, simulate_); });
    AddScenarios(app, simulate_.scenarios);
    app->get_option("PATTERN")->required()->description(kPatterns);
    AddOracleList(app, simulate_.oracles)
        ->description("e.g. cookbook,bullet; all that simulate without it");
    app->add_option("--csv", simulate_.csv,
                    "write the table there; standard output, as -, "
                    "without it")
        ->type_name("FILE");
  }

  void AddLedger() {
    CLI::App* app =
        AddCommand("ledger", "entries for the failures that the ledger does not know yet",
                   [this] { return LedgerCommand(session_); });
    app->add_flag("--propose", propose_, "print them, for a person to complete")
        ->required();
    AddCommand(
        "accuracy",
        "docs/accuracy.md: worst error per oracle, of pairs of shapes and of worlds",
        [this] { return AccuracyCommand(session_); });
  }

  void AddSchema() {
    AddCommand("schema", "the JSON Schema of scenario files, for editors", [] {
      std::cout << ScenarioSchema();
      return 0;
    });
  }

  Session session_;
  CLI::App app_;
  std::function<int()> command_;
  RunArguments run_;
  AskArguments ask_;
  SweepArguments sweep_;
  BenchArguments bench_;
  BenchWorldsArguments bench_worlds_;
  std::string benched_;
  SimulateArguments simulate_;
  ScenarioSelection explained_;
  OracleSelection oracles_;
  ScenarioSelection listed_;
  bool everything_ = false;
  bool settings_ = false;
  bool propose_ = false;
};

}  // namespace

int RunCommandLine(int argc, const char* const* argv, OracleRegistry registry,
                   const CommandLineDefaults& defaults) {
  return CommandLine(std::move(registry), defaults).Run(argc, argv);
}

}  // namespace touchstone
