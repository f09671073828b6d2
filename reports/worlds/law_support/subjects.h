#pragma once

#include <string>
#include <vector>

#include "scenarios/validate.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** What a claim is about, by index. */
struct Subjects {
  std::vector<int> bodies;     ///< Into World::bodies; all of them move.
  std::vector<int> particles;  ///< Into World::particles; all of them move.
  std::vector<int> cloths;     ///< Into World::cloths.
};

/** Returns what `claim` names, in its order; everything that moves where it names
 nothing. Names that nothing bears, and names of what does not move, are left out. */
Subjects SubjectsOf(const World& world, const Claim& claim);

/** What a law can speak of, besides bodies that move. */
struct SpeaksOf {
  bool bodies = true;
  bool particles = false;
  bool cloths = false;
};

/** Returns a fault for every name that nothing bears, that does not move, or that is of a
 kind that the law does not speak of; and one where the claim is then about nothing. */
std::vector<Fault> FaultsOfSubjects(const World& world, const Claim& claim,
                                    const SpeaksOf& speaks);

/** Returns the name of what a fault is about: "about[2]", or "about" where the claim
 names nothing. `name` is the subject's. */
std::string WhereAbout(const Claim& claim, const std::string& name);

/** Returns whether a spring or a joint is fixed to body or particle `index`. */
bool IsHeld(const World& world, AnchorKind on, int index);

/** Returns whether some push strikes body `index`. */
bool IsPushed(const World& world, int index);

/** Returns where the nodes of cloth `index` begin in WorldState::nodes. */
int FirstNodeOf(const World& world, int index);

}  // namespace touchstone
