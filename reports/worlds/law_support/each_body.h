#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scenarios/validate.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Numbers that a law derives for a body, with the names that claims use for them. */
using ExpectedNumbers = std::vector<std::pair<std::string_view, double>>;

/** Returns the faults of a claim whose law judges each body separately. They start with
 those of FaultsOfSubjects(). A body for which `why_not` returns a reason ("slips at the
 start") has a fault with that reason and `expected`. For every other body, the claim's
 numbers must agree with those that `numbers` derives. Both functions take the world and
 the index of a body. */
std::vector<Fault> FaultsOfEachBody(const World& world, const Claim& claim,
                                    std::string (*why_not)(const World&, int),
                                    std::string_view expected,
                                    ExpectedNumbers (*numbers)(const World&, int));

/** Returns the same for a law that takes exactly one body; `one` names it, as in "one
 sphere". */
std::vector<Fault> FaultsOfOneBody(const World& world, const Claim& claim,
                                   std::string_view one,
                                   std::string (*why_not)(const World&, int),
                                   std::string_view expected,
                                   ExpectedNumbers (*numbers)(const World&, int));

/** Returns whether `body` is a sphere with three equal moments of inertia. */
bool IsEvenSphere(const RigidBody& body);

}  // namespace touchstone
