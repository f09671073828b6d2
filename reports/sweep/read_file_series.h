#pragma once

#include <string>
#include <vector>

#include "reports/sweep/file_series.h"
#include "scenarios/diagnostic.h"

namespace touchstone {

/** The contact questions in a file, or its errors. */
struct FileOfQuestions {
  /** A series for each pair of shapes, each with all of its questions, in the order in
   which the pairs occur. Empty if there are errors. */
  std::vector<FileSeries> series;
  std::vector<Diagnostic> errors;
  std::vector<Diagnostic> notes;  ///< These are not errors.
};

/** Reads a table of questions (".csv"), the report of a run (".jsonl"), or a scenario
 file or folder of them. Worlds in them are left out with a note. */
FileOfQuestions ReadFileSeries(const std::string& file);

}  // namespace touchstone
