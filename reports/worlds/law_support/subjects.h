#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/worlds/truth/subjects.h"
#include "scenarios/validate.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Returns the things that `claim` names, in its order; everything that moves if it names
 nothing. Unknown names and names of static things are left out. */
Subjects SubjectsOf(const World& world, const Claim& claim);

/** The kinds of moving things that a law applies to. */
struct SpeaksOf {
  bool bodies = false;
  bool particles = false;
  bool cloths = false;
};

/** Returns a fault for every name that is unknown, static or of a kind that the law does
 not apply to; and one if the claim is then about nothing. */
std::vector<Fault> FaultsOfSubjects(const World& world, const Claim& claim,
                                    const SpeaksOf& speaks);

/** Returns the place of a fault about a subject: "about[2]", or "about" if the claim
 names nothing. `name` is the subject's. */
std::string WhereAbout(const Claim& claim, const std::string& name);

/** Returns the fault of a subject to which the law does not apply: "is ball, which spins
 at the start" for `why` = "spins at the start". */
Fault FaultAbout(const Claim& claim, const std::string& name, std::string_view why,
                 std::string_view expected);

/** Returns whether `anchor` is on a body or particle that moves. */
bool Moves(const World& world, const Anchor& anchor);

/** Returns whether a spring or a joint is fixed to body or particle `index`. */
bool IsHeld(const World& world, AnchorKind on, int index);

/** Returns whether a push acts on body `index`. */
bool IsPushed(const World& world, int index);

}  // namespace touchstone
