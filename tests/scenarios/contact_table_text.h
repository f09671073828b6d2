#pragma once

#include <span>
#include <string>

#include "scenarios/scenario.h"

namespace touchstone {

/** Returns a table of contact questions that reads back as the bodies of `scenarios` bit
 for bit. @pre Their poses have quaternions. */
std::string ContactTableText(std::span<const Scenario> scenarios);

}  // namespace touchstone
