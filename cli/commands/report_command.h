#pragma once

#include <filesystem>
#include <optional>

namespace touchstone {

/** The arguments of `touchstone report`. */
struct ReportArguments {
  std::filesystem::path run;  ///< The folder of a run, or its report.data.
  std::filesystem::path out;  ///< The page.
};

/** Writes the page of an earlier run with the viewer of this program. Returns 0. */
int ReportCommand(const ReportArguments& arguments);

/** The arguments of `touchstone compare`. */
struct CompareArguments {
  std::filesystem::path before;
  std::filesystem::path after;
  std::optional<std::filesystem::path> json;
  std::optional<std::filesystem::path> junit;
  std::optional<std::filesystem::path> html;
};

/** Prints what changed from one run to another and writes it to files. Returns 1 if
 anything got worse, otherwise 0. */
int CompareCommand(const CompareArguments& arguments);

}  // namespace touchstone
