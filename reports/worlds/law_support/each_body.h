#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scenarios/validate.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Numbers that a law derives of a body, by the names that claims give them. */
using ExpectedNumbers = std::vector<std::pair<std::string_view, double>>;

/** Returns the faults of a claim of a law that speaks of bodies, one by one: those of
 FaultsOfSubjects(); for each body that `why_not` has a reason against ("slips at the
 start"), a fault that tells it and what is `expected` instead; for each other body, the
 numbers of the claim that contradict what `numbers` derives of it. Both functions take
 the world and the index of a body. */
std::vector<Fault> FaultsOfEachBody(const World& world, const Claim& claim,
                                    std::string (*why_not)(const World&, int),
                                    std::string_view expected,
                                    ExpectedNumbers (*numbers)(const World&, int));

/** Returns the same of a law that speaks of exactly one body, "one sphere" in words. */
std::vector<Fault> FaultsOfOneBody(const World& world, const Claim& claim,
                                   std::string_view one,
                                   std::string (*why_not)(const World&, int),
                                   std::string_view expected,
                                   ExpectedNumbers (*numbers)(const World&, int));

/** Returns whether `body` is a sphere that turns about every axis as readily. */
bool IsEvenSphere(const RigidBody& body);

}  // namespace touchstone
