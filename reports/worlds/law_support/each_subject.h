#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/worlds/law_support/point_mass.h"
#include "reports/worlds/law_support/subjects.h"
#include "scenarios/validate.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Numbers that a law derives for a subject, with the names that claims use for them. */
using ExpectedNumbers = std::vector<std::pair<std::string_view, double>>;

/** The conditions under which a law judges one subject. Both functions take the world and
 the index of the subject. */
struct Conditions {
  /** Returns the reason why the law does not apply, as in "slips at the start"; empty if
   it applies. */
  std::string (*why_not)(const World&, int);
  std::string_view expected;  ///< Description of a subject to which the law applies.
  /** Returns the law's own numbers. @pre why_not() is empty. */
  ExpectedNumbers (*numbers)(const World&, int);
};

/** Returns the faults of a claim whose law judges each body separately. They start with
 those of FaultsOfSubjects(). The claim's numbers must agree with those of every body. */
std::vector<Fault> FaultsOfEachBody(const World& world, const Claim& claim,
                                    const Conditions& conditions);

/** The same conditions for bodies and particles alike. */
struct ConditionsOfPoint {
  std::string (*why_not)(const World&, const PointMass&);
  std::string_view expected;
  ExpectedNumbers (*numbers)(const World&, const PointMass&);
};

/** Returns the same for a law of bodies and particles. */
std::vector<Fault> FaultsOfEachPoint(const World& world, const Claim& claim,
                                     const ConditionsOfPoint& conditions);

/** Returns the same for a claim about exactly one body; `one` says what a claim may be
 about, as in "one box". */
std::vector<Fault> FaultsOfOneBody(const World& world, const Claim& claim,
                                   std::string_view one, const Conditions& conditions);

}  // namespace touchstone
