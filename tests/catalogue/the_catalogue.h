#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/scenario_file.h"

namespace touchstone {

/** Returns the catalogue of the source tree, read once. */
const Catalogue& TheCatalogue();

/** Returns the scenarios below `folder`, e.g. "contact/zoo/", by id. */
std::map<std::string, const Scenario*> Below(std::string_view folder);

/** Returns the contact scenarios that lie in a folder of a pair of shapes, by pair. */
std::map<std::string, std::vector<const Scenario*>> ByPairFolder();

/** Returns the folder that a scenario about these two kinds belongs to, whichever of them
 is A: their names in the order of ShapeKind, e.g. "sphere_box". */
std::string PairFolder(ShapeKind a, ShapeKind b);

}  // namespace touchstone
