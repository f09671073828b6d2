#include "cli/commands/run_command.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/input_error.h"
#include "cli/interrupt.h"
#include "cli/open_page.h"
#include "cli/output_folder.h"
#include "cli/program_identity.h"
#include "reports/accuracy/audit_run.h"
#include "reports/baseline/baseline.h"
#include "reports/journal/run_journal.h"
#include "reports/sweep/question_id.h"
#include "reports/writers/html_writer.h"
#include "reports/writers/json_writer.h"
#include "reports/writers/junit_writer.h"
#include "reports/writers/report_data.h"
#include "reports/writers/table_writer.h"
#include "reports/writers/timings_writer.h"

namespace touchstone {
namespace {

constexpr std::array kReportFiles = {"report.html", "report.data", "report.jsonl",
                                     "junit.xml"};

/** The folder of `--open` without `--out`. */
constexpr const char* kFolderToOpen = "touchstone-report";

bool IsSetUpByDefault(const Oracle* oracle) {
  return oracle->info().setup.IsDefault();
}

/** Reads a baseline. Throws InputError. */
Baseline BaselineIn(const std::filesystem::path& file) {
  BaselineResult result = ReadBaselineFile(file);
  if (!result.baseline) throw InputError(ToString(result.diagnostics.front()));
  return std::move(*result.baseline);
}

/** Reads a table of accuracy. Throws InputError. */
std::string AccuracyIn(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(in), {});
  if (text.empty()) {
    throw InputError(fmt::format(
        "cannot read {}; expected what `touchstone accuracy` prints", file.string()));
  }
  return text;
}

/** Returns the command that asks the same again, without what it does with the answers.
 */
std::string CommandOf(const RunArguments& arguments) {
  std::string command = "touchstone run";
  for (const std::string& pattern : arguments.scenarios.patterns)
    command += " " + pattern;
  command += " --subject " + arguments.oracles.subject;
  if (!arguments.oracles.against.empty())
    command += fmt::format(" --against {}", fmt::join(arguments.oracles.against, ","));
  return command;
}

void WriteReports(const RunReport& report, const RunFacts& facts,
                  const OutputFolder& out) {
  const std::string data = ReportData(report, facts);
  out.Write("report.data", [&](std::ostream& to) { to << data; });
  out.Write("report.html", [&](std::ostream& to) { WritePage(data, to); });
  out.Write("report.jsonl", [&](std::ostream& to) { WriteJson(report, to); });
  out.Write("junit.xml", [&](std::ostream& to) { WriteJUnit(report, facts.rule, to); });
}

/** The worlds of a run that are kept in its folder while it runs. */
class KeptWorlds {
 public:
  /** Without `resume`, forgets what an earlier run left. */
  KeptWorlds(const std::filesystem::path& folder, bool resume)
      : journal_(folder / "run.unfinished.sqlite", ProgramIdentity()) {
    if (resume || journal_.size() == 0) return;
    std::cerr << fmt::format(
        "touchstone: {} judged motions of an interrupted run are discarded; --resume "
        "would "
        "have used them\n",
        journal_.size());
    journal_.Clear();
  }

  WorldsOptions Options() {
    return {.find = [this](const WorldScenario& scenario, const OracleInfo& oracle)
                -> std::optional<Examination> { return journal_.Find(scenario, oracle); },
            .keep =
                [this](const WorldScenario& scenario, const OracleInfo& oracle,
                       const Examination& examination) {
                  Keep(scenario, oracle, examination);
                }};
  }

  /** Returns whether a result could not be kept. */
  bool has_failed() const { return has_failed_; }

  /** Throws what went wrong when a result was to be kept. */
  void Rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

  std::size_t size() const { return journal_.size(); }
  void Remove() { journal_.Remove(); }

 private:
  /** No exception may leave a thread of the run. */
  void Keep(const WorldScenario& scenario, const OracleInfo& oracle,
            const Examination& examination) {
    try {
      journal_.Keep(scenario, oracle, examination);
    } catch (const SweepFileError&) {
      if (!has_failed_.exchange(true)) error_ = std::current_exception();
    }
  }

  RunJournal journal_;
  std::atomic<bool> has_failed_ = false;
  std::exception_ptr error_;
};

/** Returns the ids of questions that only their files ask. */
std::set<std::string, std::less<>> OnlyInFiles(const Session& session,
                                               const ScenarioSelection& selection,
                                               const Questions& questions) {
  std::set<std::string, std::less<>> ids =
      OutsideCatalogue(selection, questions, session.catalogue());
  std::erase_if(ids, [](const std::string& id) { return QuestionOfId(id).has_value(); });
  return ids;
}

}  // namespace

int RunCommand(const Session& session, const RunArguments& arguments) try {
  const std::vector<const Oracle*> oracles =
      SelectOracles(session.registry, arguments.oracles);
  const Questions questions = SelectQuestions(arguments.scenarios);
  const Ledger ledger = arguments.ledger
                            ? ReadLedgerOf(*arguments.ledger)
                            : BuiltInLedger(session, arguments.scenarios, questions);
  SuiteOptions options{
      .jobs = arguments.jobs,
      // The ledger covers the whole default catalogue and every reference, all set up as
      // the adapters do.
      .partial = !arguments.scenarios.patterns.empty() ||
                 !arguments.oracles.against.empty() ||
                 !std::all_of(oracles.begin(), oracles.end(), IsSetUpByDefault) ||
                 arguments.scenarios.catalogues != std::vector{session.catalogue()},
      .quiet = arguments.quiet};
  if (arguments.audit && options.partial) {
    throw InputError(
        "--audit is about the whole built-in catalogue on all oracles; expected no "
        "patterns, no --against and no --set");
  }
  std::optional<std::string> accuracy;
  if (arguments.audit) accuracy = AccuracyIn(*arguments.audit);
  std::optional<std::filesystem::path> folder = arguments.out;
  if (!folder && arguments.open) folder = kFolderToOpen;
  std::optional<OutputFolder> out;
  if (folder) out.emplace(*folder);
  for (const char* file : kReportFiles) {
    if (out) out->Check(file);
  }
  std::optional<Baseline> baseline;
  if (arguments.baseline) baseline = BaselineIn(*arguments.baseline);
  const Interrupt interrupt(WorkingEngines::kEnd);
  std::optional<KeptWorlds> kept;
  options.stop = [&kept] {
    return (kept && kept->has_failed()) || Interrupt::signal() != 0;
  };
  if (out) kept.emplace(*folder, arguments.resume);
  if (kept) options.worlds = kept->Options();
  RunReport report = RunSuite(session, questions, oracles, ledger, options);
  if (kept) kept->Rethrow();
  if (const int signal = Interrupt::signal()) {
    std::cerr << (kept ? fmt::format(
                             "touchstone: stopped; {} keeps the {} judged motions, "
                             "the same command with --resume goes on from there.{}\n",
                             folder->string(), kept->size(),
                             std::filesystem::exists(*folder / kReportFiles[0])
                                 ? " Its report.html is still that of an earlier run."
                                 : "")
                       : "touchstone: stopped; with --out, --resume would go on from "
                         "there\n");
    return 128 + signal;
  }
  if (accuracy) {
    const std::vector<std::string> faults = AuditRun(report, *accuracy);
    report.faults.insert(report.faults.end(), faults.begin(), faults.end());
  }
  if (baseline) CompareWithBaseline(report, *baseline);

  WriteTable(report,
             {.colours = session.terminal.colours,
              .quiet = arguments.quiet,
              .width = session.terminal.width,
              .rule = arguments.rule},
             std::cout);
  if (arguments.timings) WriteTimings(report, std::cout);
  if (!session.registry.missing().empty() && arguments.oracles.against.empty()) {
    std::vector<std::string_view> names;
    for (const MissingOracle& missing : session.registry.missing())
      names.push_back(missing.name);
    std::cout << fmt::format("not available: {}; see `touchstone oracles`\n",
                             fmt::join(names, ", "));
  }
  if (out) {
    WriteReports(report,
                 {.program = "touchstone " TOUCHSTONE_VERSION,
                  .command = CommandOf(arguments),
                  .rule = arguments.rule,
                  .own = OnlyInFiles(session, arguments.scenarios, questions)},
                 *out);
    kept->Remove();
    std::cout << fmt::format("page: {}\n", (*folder / "report.html").string());
  }
  if (arguments.open) OpenPage(*folder / "report.html");
  return ExitCode(report, arguments.rule);
} catch (const SweepFileError& error) {
  throw InputError(error.what());
}

}  // namespace touchstone
