#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "scenarios/scenario.h"

namespace touchstone {

/** The contact questions in a file that are about one pair of shapes, in its order. */
struct FileSeries {
  /** The path that the user gave: a table, a report, or a scenario file or folder. */
  std::string file;
  std::string digest;  ///< DigestOf() all questions in the file, whatever their shapes.
  ShapeKind A = ShapeKind::kBox;
  ShapeKind B = ShapeKind::kBox;
  std::uint64_t first = 0;  ///< Index of the first question among those of the pair.
  std::uint64_t count = 0;
  /** All questions of the pair. Null in a series that was read from the file of a sweep,
   which keeps only the results. */
  std::shared_ptr<const std::vector<Scenario>> questions = nullptr;
};

/** Returns 16 hexadecimal digits that identify `questions` by all that they say but their
 ids, titles and sources. */
std::string DigestOf(const std::vector<Scenario>& questions);

/** Returns the id of question `index`, such as
 "sweep/from/poses_3f07a1c2d4e5b687/box_box/" and the index with twenty digits. */
std::string IdOf(const FileSeries& series, std::uint64_t index);

/** Returns question `index`. @pre series.questions. */
Scenario ScenarioAt(const FileSeries& series, std::uint64_t index);

/** Returns the command line that repeats question `index`. */
std::string ReplayOf(const FileSeries& series, std::uint64_t index);

}  // namespace touchstone
