#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/baseline/baseline.h"
#include "reports/finding/finding.h"
#include "reports/finding/ledger.h"
#include "scenarios/diagnostic.h"

namespace touchstone {

/** The largest inflated size that a reader accepts, several times that of a run of the
 whole catalogue. [bytes] */
inline constexpr std::size_t kMostReportData = std::size_t{1} << 27;

/** An oracle as a report names it. */
struct ReadOracle {
  std::string name;
  std::string version;  ///< That of its library.
};

/** The parts of a report's data that this program uses. */
struct ReadReportData {
  Baseline baseline;  ///< The findings, each with its rounding.
  /** The text of the file of each question, by its id. */
  std::map<std::string, std::string> questions;
  std::vector<ReadOracle> oracles;  ///< In the order of the run.
  std::string command;              ///< The command that made the run.
  std::string bytes;                ///< The data as read, deflated, for WritePage().
};

/** The data of a report, or the error of its file. */
struct ReadReportResult {
  std::optional<ReadReportData>
      data;  ///< Present if and only if there are no diagnostics.
  std::vector<Diagnostic> diagnostics;  ///< One, at line 1.
};

/** Reads what ReportData() wrote, of this version of the format. Whatever the bytes, it
 reads no more than they hold, keeps at most `most` inflated bytes, and refuses findings
 that refer to anything outside the file. Tracks are not read: a page checks them.
 `file` is the name used in diagnostics. */
ReadReportResult ReadReport(std::string bytes, const std::filesystem::path& file,
                            std::size_t most = kMostReportData);

/** Reads report data from a file, or from `report.data` in a folder that `touchstone run
 --out` wrote. */
ReadReportResult ReadReportFile(const std::filesystem::path& file_or_folder);

}  // namespace touchstone
