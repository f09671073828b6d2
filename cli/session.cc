#include "cli/session.h"

#include <chrono>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cli/input_error.h"
#include "cli/progress_bar.h"
#include "reports/ledger/ledger_file.h"
#include "reports/text/counted.h"

namespace touchstone {
namespace {

std::string Today() {
  const std::chrono::year_month_day today(
      std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()));
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(today.year()),
                     static_cast<unsigned>(today.month()),
                     static_cast<unsigned>(today.day()));
}

std::filesystem::path BuiltInLedgerFile(const Session& session) {
  return session.data / "known_discrepancies.toml";
}

}  // namespace

Ledger ReadLedgerOf(const std::filesystem::path& file) {
  LedgerResult result = ReadLedgerFile(file);
  if (result.ledger) return std::move(*result.ledger);
  std::string text =
      Counted(result.diagnostics.size(), "error") + " in the ledger: nothing was run";
  for (const Diagnostic& diagnostic : result.diagnostics)
    text += fmt::format("\n{}", ToString(diagnostic));
  throw InputError(text);
}

Ledger BuiltInLedger(const Session& session, const ScenarioSelection& selection,
                     const Questions& questions) {
  const std::filesystem::path file = BuiltInLedgerFile(session);
  if (!std::filesystem::exists(file)) return {};
  Ledger ledger = ReadLedgerOf(file);
  ledger.outside_catalogue = OutsideCatalogue(selection, questions, session.catalogue());
  return ledger;
}

RunReport RunSuite(const Session& session, const Questions& questions,
                   std::span<const Oracle* const> oracles, const Ledger& ledger,
                   const SuiteOptions& options) {
  ProgressBar bar(session.terminal, options.quiet);
  RunOptions run;
  run.jobs = options.jobs;
  run.today = Today();
  run.partial = options.partial;
  run.stop = options.stop;
  run.worlds = options.worlds;
  // A program need not have all engines of the built-in ledger.
  if (!options.partial || ledger.file != BuiltInLedgerFile(session)) {
    run.is_oracle = [&session](std::string_view name) {
      return session.registry.MayExist(name);
    };
  }
  run.on_progress = [&bar](std::size_t done, std::size_t total, double part) {
    bar.Show(done, total, part);
  };
  return Run(questions, oracles, ledger, run);
}

}  // namespace touchstone
