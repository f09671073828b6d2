#pragma once

#include <cstdint>
#include <string>

#include "scenarios/generators/generate.h"
#include "scenarios/scenario.h"

namespace touchstone {

/** A seeded series of generated contact questions, the same on every machine. */
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

/** Returns the id of question `index`, such as "sweep/random/box_box/seed_1/0...42". */
std::string IdOf(const QuestionSeries& series, std::uint64_t index);

/** Returns question `index` of the family as a scenario. */
Scenario ScenarioAt(const QuestionSeries& series, std::uint64_t index);

/** Returns the command line that repeats question `index`. */
std::string ReplayOf(const QuestionSeries& series, std::uint64_t index);

}  // namespace touchstone
