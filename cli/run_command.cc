#include "cli/run_command.h"

#include <fstream>
#include <iostream>

#include <fmt/format.h>

#include "cli/input_error.h"
#include "reports/writers/html_writer.h"
#include "reports/writers/json_writer.h"
#include "reports/writers/junit_writer.h"
#include "reports/writers/table_writer.h"

namespace touchstone {
namespace {

void WriteFile(const std::filesystem::path& file, const RunReport& report,
               void (*write)(const RunReport&, std::ostream&)) {
  std::ofstream out(file, std::ios::binary);
  write(report, out);
  out.close();
  if (!out) throw InputError(fmt::format("cannot write {}", file.string()));
}

void WriteReports(const std::filesystem::path& folder, const RunReport& report) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw InputError(
        fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
  }
  WriteFile(folder / "index.html", report, WriteHtml);
  WriteFile(folder / "report.json", report, WriteJson);
  WriteFile(folder / "junit.xml", report, WriteJUnit);
}

}  // namespace

int RunCommand(const Session& session, const RunArguments& arguments) {
  const std::vector<const Oracle*> oracles =
      SelectOracles(session.registry, arguments.oracles);
  const Ledger ledger = LoadLedger(session, arguments.ledger);
  const std::vector<Scenario> scenarios = SelectScenarios(arguments.scenarios);
  const SuiteOptions options{
      .jobs = arguments.jobs,
      // The ledger speaks of the whole default catalogue and of every reference.
      .partial = !arguments.scenarios.patterns.empty() ||
                 !arguments.oracles.against.empty() ||
                 arguments.scenarios.catalogues != std::vector{session.catalogue()},
      .quiet = arguments.quiet};
  const RunReport report = RunSuite(session, scenarios, oracles, ledger, options);

  WriteTable(report,
             {.colours = session.terminal.colours,
              .quiet = arguments.quiet,
              .fail_on = arguments.fail_on},
             std::cout);
  if (arguments.out) WriteReports(*arguments.out, report);
  const int code = ExitCode(report, arguments.fail_on);
  if (code == 2) {
    std::cerr << "touchstone: nothing was verified: " << report.subject
              << " passed no measure of any scenario\n";
  }
  return code;
}

}  // namespace touchstone
