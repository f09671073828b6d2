#pragma once

#include <cstdint>
#include <string>

#include "scenarios/generators/generate.h"
#include "scenarios/scenario.h"

namespace touchstone {

/** A seeded series of generated questions, the same on every machine. */
struct QuestionSeries {
  Family family = Family::kRandom;
  ShapeKind A = ShapeKind::kBox;
  ShapeKind B = ShapeKind::kBox;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;  ///< Index of the first question.
  std::uint64_t count = 1000;
  /** Number of questions of a worst-case search, see ClimbOf(); 1: none. */
  std::uint64_t climb = 1;
};

/** Returns question `index` of the family as a scenario with an id such as
 "sweep/random/box_box/seed_1/0...42". */
Scenario ScenarioAt(const QuestionSeries& series, std::uint64_t index);

/** Returns the command line that repeats question `index`. */
std::string ReplayOf(const QuestionSeries& series, std::uint64_t index);

/** The number of questions in a block: the unit that is computed, committed and shared
 out. Small enough that a thousand questions keep two threads busy, large enough that
 causes which need many questions are found. */
inline constexpr std::uint64_t kBlockSize = 256;

/** Returns the number of blocks of a series; the last one may be smaller. */
std::uint64_t BlockCount(const QuestionSeries& series);

/** Returns block `block` of `series`, which is a series itself.
 @pre block < BlockCount(series). */
QuestionSeries BlockOf(const QuestionSeries& series, std::uint64_t block);

}  // namespace touchstone
