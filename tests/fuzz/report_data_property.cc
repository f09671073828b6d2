#include "tests/fuzz/report_data_property.h"

#include <cmath>

#include "reports/writers/data/data_file.h"
#include "reports/writers/data/deflate.h"
#include "reports/writers/read_report_data.h"

namespace touchstone {
namespace {

/** Small, so that a bomb is one for the fuzzer too. */
constexpr std::size_t kMost = std::size_t{1} << 20;

std::string FaultOf(std::string bytes) {
  const ReadReportResult read = ReadReport(bytes, "f.data", kMost);
  if (read.data.has_value() != read.diagnostics.empty())
    return "neither data nor a diagnostic, or both";
  for (const Diagnostic& diagnostic : read.diagnostics) {
    if (diagnostic.line != 1 || diagnostic.what.empty() || diagnostic.expected.empty())
      return "a diagnostic without a place or a text: " + ToString(diagnostic);
  }
  if (!read.data) return "";
  if (read.data->bytes != bytes) return "other bytes than those that were read";
  for (const auto& [cell, measured] : read.data->baseline.cells) {
    if (measured.verdict > Verdict::kInvalid) return "accepted a verdict that is none";
    if (NameOf(cell.measure).empty()) return "accepted a measure that is none";
  }
  const Unpacked unpacked = UnpackData(bytes, kMost);
  if (!unpacked.file) return "cannot be taken apart again";
  const ReadReportResult again =
      ReadReport(PackData(*unpacked.file), "f.data", 4 * kMost);
  if (!again.data) return "refused the packed file";
  const auto& cells = again.data->baseline.cells;
  if (cells.size() != read.data->baseline.cells.size()) return "read back differently";
  // A NaN beside a number is worse; anything else is not worse than itself.
  for (const Change& change : Compare(read.data->baseline, again.data->baseline)) {
    if (!std::isnan(change.before.value_or(Baseline::Measured{}).value))
      return "differs from itself: " + change.what;
  }
  return "";
}

}  // namespace

std::string FaultOfReadingReportData(std::string_view bytes) {
  const std::string fault = FaultOf(std::string(bytes));
  // Few mutations of a zlib stream are one: the contents are tried for themselves.
  return fault.empty() ? FaultOf(Deflated(bytes)) : fault;
}

}  // namespace touchstone
