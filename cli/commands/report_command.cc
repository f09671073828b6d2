#include "cli/commands/report_command.h"

#include <algorithm>
#include <functional>
#include <iostream>
#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/input_error.h"
#include "cli/output_folder.h"
#include "cli/select_oracles.h"
#include "reports/baseline/baseline.h"
#include "reports/sweep/database.h"
#include "reports/sweep/sweep_page.h"
#include "reports/writers/comparison_writer.h"
#include "reports/writers/html_writer.h"
#include "reports/writers/read_report_data.h"
#include "reports/writers/report_data.h"

namespace touchstone {
namespace {

/** Reads the data of a run. Throws InputError. */
ReadReportData DataIn(const std::filesystem::path& run) {
  ReadReportResult result = ReadReportFile(run);
  if (!result.data) throw InputError(ToString(result.diagnostics.front()));
  return std::move(*result.data);
}

/** The place of a file that a command writes. */
class OutputFile {
 public:
  /** Throws InputError if the file cannot be written. */
  explicit OutputFile(const std::filesystem::path& file)
      : folder_(file.has_parent_path() ? file.parent_path() : "."),
        name_(file.filename()) {
    if (name_.empty())
      throw InputError("cannot write " + file.string() + "; expected the name of a file");
    folder_.Check(name_);
  }

  void Write(const std::function<void(std::ostream&)>& write) const {
    folder_.Write(name_, write);
  }

 private:
  OutputFolder folder_;
  std::filesystem::path name_;
};

/** Returns the file of a finished sweep that `run` is or holds; a run's data have
 precedence. */
std::optional<std::filesystem::path> SweepIn(const std::filesystem::path& run) {
  std::error_code error;
  if (!std::filesystem::is_directory(run, error)) {
    return run.extension() == ".sqlite" ? std::optional(run) : std::nullopt;
  }
  const std::filesystem::path sweep = run / "sweep.sqlite";
  if (std::filesystem::exists(run / "report.data", error) ||
      !std::filesystem::exists(sweep, error)) {
    return std::nullopt;
  }
  return sweep;
}

/** Questions of a sweep that are asked again: some ten seconds of work with all engines,
 for contact questions. A world, with its variants and smaller steps, takes as long as
 many of them. */
constexpr KeptLimits kLimits = {.contacts = 200, .worlds = 40};

/** Asks the kept questions of a sweep again and returns the data of the page. Throws
 InputError. */
std::string DataOfSweep(const Session& session, const std::filesystem::path& file,
                        int jobs) try {
  const auto oracle_named = [&](const std::string& name) -> const Oracle& {
    return OracleNamed(session.registry, name);
  };
  const KeptQuestions kept = ReadKeptQuestions(file, kLimits, oracle_named);
  std::vector<const Oracle*> oracles;
  for (const std::string& name : kept.subjects)
    oracles.push_back(&OracleNamed(session.registry, name));
  const RunReport report =
      RunSuite(session, kept.questions, oracles, {}, {.jobs = jobs, .partial = true});
  return WithSweep(ReportData(report, {.program = "touchstone " TOUCHSTONE_VERSION,
                                       .command = "touchstone report " + file.string(),
                                       .rule = {}}),
                   file, BuiltInLedger(session, {}, {}));
} catch (const SweepFileError& error) {
  throw InputError(error.what());
}

// Returns the findings of an oracle of a run, under the name `as`. Throws InputError.
Baseline OfOracle(const ReadReportData& run, const std::string& oracle,
                  const std::string& as) {
  Baseline findings = FindingsOf(run.baseline, oracle, as);
  if (!findings.cells.empty()) return findings;
  std::set<std::string> names;
  for (const auto& [cell, measured] : run.baseline.cells) names.insert(cell.oracle);
  throw InputError(fmt::format("the run has no findings of {}; expected one of: {}",
                               oracle, fmt::join(names, ", ")));
}

void WriteIfAsked(const std::optional<std::filesystem::path>& file,
                  const std::function<void(std::ostream&)>& write) {
  if (file) OutputFile(*file).Write(write);
}

}  // namespace

int ReportCommand(const Session& session, const ReportArguments& arguments) {
  if (const auto sweep = SweepIn(arguments.run)) {
    const OutputFile out(arguments.out);
    const std::string data = DataOfSweep(session, *sweep, arguments.jobs);
    out.Write([&](std::ostream& to) { WritePage(data, to); });
    return 0;
  }
  const ReadReportData data = DataIn(arguments.run);
  OutputFile(arguments.out).Write([&](std::ostream& to) { WritePage(data.bytes, to); });
  return 0;
}

int CompareCommand(const CompareArguments& arguments) {
  const bool of_oracles = !arguments.oracle.empty() || !arguments.with.empty();
  if (of_oracles && (arguments.oracle.empty() || arguments.with.empty()))
    throw InputError("compare: expected --oracle ORACLE with --with ORACLE");
  if (!of_oracles && arguments.after.empty())
    throw InputError("compare: expected NEW, or --oracle and --with for two oracles");
  const ReadReportData before = DataIn(arguments.before);
  const ReadReportData after = arguments.after.empty() ? before : DataIn(arguments.after);
  const std::vector<Change> changes =
      of_oracles ? Compare(OfOracle(before, arguments.oracle, arguments.with),
                           OfOracle(after, arguments.with, arguments.with))
                 : Compare(before.baseline, after.baseline);
  const Comparison comparison{
      .before = of_oracles ? arguments.oracle : arguments.before.string(),
      .after = of_oracles ? arguments.with : arguments.after.string(),
      .changes = changes};
  WriteComparison(comparison, std::cout);
  WriteIfAsked(arguments.json,
               [&](std::ostream& to) { WriteComparisonJson(comparison, to); });
  WriteIfAsked(arguments.junit,
               [&](std::ostream& to) { WriteComparisonJUnit(comparison, to); });
  WriteIfAsked(arguments.html, [&](std::ostream& to) {
    WritePage(WithComparison(after, comparison), to);
  });
  const bool is_worse =
      std::ranges::any_of(changes, [](const Change& c) { return IsWorse(c.kind); });
  return is_worse ? 1 : 0;
}

}  // namespace touchstone
