#pragma once

#include <string>
#include <variant>
#include <vector>

#include "scenarios/scenario.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** A question of either kind, with its provenance. */
using Question = std::variant<Scenario, WorldScenario>;

/** Returns the id of `question`. */
const std::string& IdOf(const Question& question);

/** Returns the bodies of `question`, in order; they live as long as it. */
std::vector<Body*> BodiesOf(Question& question);
std::vector<const Body*> BodiesOf(const Question& question);

/** Returns the sizes of `shape` except the vertices of a hull, in the order of a file. */
std::vector<double*> SizesOf(Shape& shape);

/** Returns every number of `question` that a shorter one may replace: sizes, vertices,
 positions, and for a world masses, velocities, coefficients, loads and the clock. The
 entries of rotations depend on each other and are left out. */
std::vector<double*> NumbersOf(Question& question);

/** Returns whether `question` has no fault, so that engines may be asked. */
bool IsValid(const Question& question);

/** Returns the text of its file. @pre IsValid(question) */
std::string TextOf(const Question& question);

}  // namespace touchstone
