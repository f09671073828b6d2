#include "cli/session.h"

#include <chrono>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cli/input_error.h"
#include "cli/progress_bar.h"
#include "reports/counted.h"
#include "reports/ledger_file.h"

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

Ledger LoadLedger(const Session& session,
                  const std::optional<std::filesystem::path>& file) {
  const std::filesystem::path built_in =
      session.defaults.data / "known_discrepancies.toml";
  if (!file && !std::filesystem::exists(built_in)) return {};
  LedgerResult result = ReadLedgerFile(file.value_or(built_in));
  if (result.ledger) return std::move(*result.ledger);
  std::string text;
  for (const Diagnostic& diagnostic : result.diagnostics) {
    text += ToString(diagnostic) + "\n";
  }
  throw InputError(text + Counted(result.diagnostics.size(), "error") +
                   " in the ledger: nothing was run");
}

RunReport RunSuite(const Session& session, const Questions& questions,
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
  return Run(questions, oracles, ledger, run);
}

}  // namespace touchstone
