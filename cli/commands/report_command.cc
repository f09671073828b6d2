#include "cli/commands/report_command.h"

#include <algorithm>
#include <functional>
#include <iostream>
#include <ostream>
#include <vector>

#include "cli/input_error.h"
#include "cli/output_folder.h"
#include "reports/baseline/baseline.h"
#include "reports/writers/comparison_writer.h"
#include "reports/writers/html_writer.h"
#include "reports/writers/read_report_data.h"

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

void WriteIfAsked(const std::optional<std::filesystem::path>& file,
                  const std::function<void(std::ostream&)>& write) {
  if (file) OutputFile(*file).Write(write);
}

}  // namespace

int ReportCommand(const ReportArguments& arguments) {
  const ReadReportData data = DataIn(arguments.run);
  OutputFile(arguments.out).Write([&](std::ostream& to) { WritePage(data.bytes, to); });
  return 0;
}

int CompareCommand(const CompareArguments& arguments) {
  const ReadReportData before = DataIn(arguments.before);
  const ReadReportData after = DataIn(arguments.after);
  const std::vector<Change> changes = Compare(before.baseline, after.baseline);
  const Comparison comparison{.before = arguments.before.string(),
                              .after = arguments.after.string(),
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
