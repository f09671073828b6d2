#include "cli/commands/run_command.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/input_error.h"
#include "cli/open_page.h"
#include "cli/output_folder.h"
#include "reports/baseline/baseline.h"
#include "reports/writers/html_writer.h"
#include "reports/writers/json_writer.h"
#include "reports/writers/junit_writer.h"
#include "reports/writers/report_data.h"
#include "reports/writers/table_writer.h"

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
  out.Write("junit.xml", [&](std::ostream& to) { WriteJUnit(report, to); });
}

}  // namespace

int RunCommand(const Session& session, const RunArguments& arguments) {
  const std::vector<const Oracle*> oracles =
      SelectOracles(session.registry, arguments.oracles);
  const Questions questions = SelectQuestions(arguments.scenarios);
  const Ledger ledger = arguments.ledger
                            ? ReadLedgerOf(*arguments.ledger)
                            : BuiltInLedger(session, arguments.scenarios, questions);
  const SuiteOptions options{
      .jobs = arguments.jobs,
      // The ledger covers the whole default catalogue and every reference, all set up as
      // the adapters do.
      .partial = !arguments.scenarios.patterns.empty() ||
                 !arguments.oracles.against.empty() ||
                 !std::all_of(oracles.begin(), oracles.end(), IsSetUpByDefault) ||
                 arguments.scenarios.catalogues != std::vector{session.catalogue()},
      .quiet = arguments.quiet};
  std::optional<std::filesystem::path> folder = arguments.out;
  if (!folder && arguments.open) folder = kFolderToOpen;
  std::optional<OutputFolder> out;
  if (folder) out.emplace(*folder);
  for (const char* file : kReportFiles) {
    if (out) out->Check(file);
  }
  std::optional<Baseline> baseline;
  if (arguments.baseline) baseline = BaselineIn(*arguments.baseline);
  RunReport report = RunSuite(session, questions, oracles, ledger, options);
  if (baseline) CompareWithBaseline(report, *baseline);

  WriteTable(report,
             {.colours = session.terminal.colours,
              .quiet = arguments.quiet,
              .width = session.terminal.width,
              .fail_on = arguments.fail_on},
             std::cout);
  if (!session.registry.missing().empty() && arguments.oracles.against.empty()) {
    std::vector<std::string_view> names;
    for (const MissingOracle& missing : session.registry.missing())
      names.push_back(missing.name);
    std::cout << fmt::format("not installed: {}; see `touchstone oracles`\n",
                             fmt::join(names, ", "));
  }
  if (out) {
    WriteReports(report,
                 {.program = "touchstone " TOUCHSTONE_VERSION,
                  .command = CommandOf(arguments),
                  .fail_on = arguments.fail_on},
                 *out);
    std::cout << fmt::format("page: {}\n", (*folder / "report.html").string());
  }
  if (arguments.open) OpenPage(*folder / "report.html");
  return ExitCode(report, arguments.fail_on);
}

}  // namespace touchstone
