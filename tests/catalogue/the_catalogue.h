#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/scenario_file.h"

namespace touchstone {

/** Returns the catalogue of the source tree, read once. */
const Catalogue& TheCatalogue();

/** Returns the scenarios below `folder`, e.g. "contact/zoo/", indexed by id. */
std::map<std::string, const Scenario*> Below(std::string_view folder);

/** Returns the contact scenarios in the folders of shape pairs, indexed by pair. */
std::map<std::string, std::vector<const Scenario*>> ByPairFolder();

/** Returns the folder of scenarios with these two kinds, in either order: their names in
 the order of ShapeKind, e.g. "sphere_box". */
std::string PairFolder(ShapeKind a, ShapeKind b);

}  // namespace touchstone
