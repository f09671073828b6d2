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
#include "cli/output_folder.h"
#include "reports/baseline/baseline.h"
#include "reports/writers/html_writer.h"
#include "reports/writers/json_writer.h"
#include "reports/writers/junit_writer.h"
#include "reports/writers/report_data.h"
#include "reports/writers/table_writer.h"

namespace touchstone {
namespace {

struct ReportFile {
  const char* name;
  void (*write)(const RunReport&, std::ostream&);
};

constexpr std::array<ReportFile, 3> kReportFiles = {
    {{"index.html", WriteHtml}, {"report.json", WriteJson}, {"junit.xml", WriteJUnit}}};

bool IsSetUpByDefault(const Oracle* oracle) {
  return oracle->info().setup.IsDefault();
}

/** Reads a baseline. Throws InputError. */
Baseline BaselineIn(const std::filesystem::path& file) {
  BaselineResult result = ReadBaselineFile(file);
  if (!result.baseline) throw InputError(ToString(result.diagnostics.front()));
  return std::move(*result.baseline);
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
  std::optional<OutputFolder> out;
  if (arguments.out) out.emplace(*arguments.out);
  for (const ReportFile& file : kReportFiles) {
    if (out) out->Check(file.name);
  }
  std::optional<Baseline> baseline;
  if (arguments.baseline) baseline = BaselineIn(*arguments.baseline);
  RunReport report = RunSuite(session, questions, oracles, ledger, options);
  if (baseline) CompareWithBaseline(report, *baseline);

  WriteTable(report,
             {.colours = session.terminal.colours,
              .quiet = arguments.quiet,
              .fail_on = arguments.fail_on},
             std::cout);
  if (!session.registry.missing().empty() && arguments.oracles.against.empty()) {
    std::vector<std::string_view> names;
    for (const MissingOracle& missing : session.registry.missing())
      names.push_back(missing.name);
    std::cout << fmt::format("not installed: {}; see `touchstone oracles`\n",
                             fmt::join(names, ", "));
  }
  for (const ReportFile& file : kReportFiles) {
    if (out) out->Write(file.name, [&](std::ostream& to) { file.write(report, to); });
  }
  if (out) {
    out->Write("report.data", [&](std::ostream& to) {
      to << ReportData(report, {.program = "touchstone 0.1.0",
                                .command = "touchstone run",
                                .fail_on = arguments.fail_on});
    });
  }
  return ExitCode(report, arguments.fail_on);
}

}  // namespace touchstone
