#include "cli/session.h"

#include <chrono>
#include <string>

#include <fmt/format.h>

#include "cli/input_error.h"
#include "cli/progress_bar.h"

namespace touchstone {
namespace {

std::string Today() {
  const std::chrono::year_month_day today(
      std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()));
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(today.year()),
                     static_cast<unsigned>(today.month()),
                     static_cast<unsigned>(today.day()));
}

}  // namespace

Ledger LoadLedger(const Session&, const std::optional<std::filesystem::path>&) {
  return {};
}

RunReport RunSuite(const Session& session, std::span<const Scenario> scenarios,
                   std::span<const Oracle* const> oracles, const Ledger& ledger,
                   const SuiteOptions& options) {
  ProgressBar bar(session.terminal.progress && !options.quiet);
  RunOptions run;
  run.jobs = options.jobs;
  run.today = Today();
  run.partial = options.partial;
  run.on_progress = [&bar](std::size_t done, std::size_t total) {
    bar.Show(done, total);
  };
  return Run(scenarios, oracles, ledger, run);
}

}  // namespace touchstone
