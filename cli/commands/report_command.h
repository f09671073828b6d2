#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/session.h"

namespace touchstone {

/** The arguments of `touchstone report`. */
struct ReportArguments {
  /** The folder of a run or of a sweep, or its report.data or sweep.sqlite. */
  std::filesystem::path run;
  std::filesystem::path out;  ///< The page.
  int jobs = 0;               ///< Threads that ask a sweep's questions again.
};

/** Writes the page of an earlier run with the viewer of this program. The questions of
 failures that a sweep has kept are asked again, so that the page shows the answers.
 Returns 0. */
int ReportCommand(const Session& session, const ReportArguments& arguments);

/** The arguments of `touchstone compare`. */
struct CompareArguments {
  std::filesystem::path before;
  std::filesystem::path
      after;           ///< Empty: the same run, of which two oracles are compared.
  std::string oracle;  ///< Compares this oracle …
  std::string with;    ///< … with this one; empty: each with itself.
  std::optional<std::filesystem::path> json;
  std::optional<std::filesystem::path> junit;
  std::optional<std::filesystem::path> html;
};

/** Prints what changed from one run to another, or from one oracle to another, and writes
 it to files. Returns 1 if
 anything got worse, otherwise 0. */
int CompareCommand(const CompareArguments& arguments);

}  // namespace touchstone
