#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "scenarios/diagnostic.h"
#include "scenarios/scenario.h"

namespace touchstone {

/** The contact questions of a table, one a row, or its errors. */
struct ContactTable {
  /** In the order of the rows; the title of each names its line. Empty after an error. */
  std::vector<Scenario> scenarios;
  std::vector<Diagnostic> errors;  ///< The first of each wrong row, of five rows at most.
  std::optional<Diagnostic> note;  ///< On quaternions that were normalised; not an error.
};

/** Reads a table of contact questions, a CSV file (docs/contact_table.md). Its first line
 names the columns, in any order. A column is a number of a body, named as in a scenario
 file: "A.radius", "B.half_extents.x", "A.position.z", "B.quaternion.w". A column "name"
 holds a text for the title of the question. The rows are validated, and quaternions of
 few digits normalised, as those of scenario files.
 `file_name` is the name used in diagnostics and as the source of the questions. */
ContactTable ReadContactTable(std::string_view text, std::string_view file_name);

/** Reads the table in `file`. A pipe is an error: it could not be read again. */
ContactTable ReadContactTableFile(const std::filesystem::path& file);

}  // namespace touchstone
