#pragma once

#include <string>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** What the motion of one small world shows. */
struct WorldCheck {
  std::string world;   ///< What happens in it: "a box is thrown".
  std::string reason;  ///< Why it was not simulated; empty if it was.
  /** How the motion differs, in words; empty if it is right to kSameMotion. */
  std::string wrong;
  /** The mistakes that explain the difference, each by itself; empty if none does. */
  std::vector<std::string> mistakes;
};

/** The difference of two motions, relative to the motion itself, up to which they are
 alike: above the error of a first-order scheme in these worlds, at most 1 % (its error is
 g t dt/2 on the way of a throw, 0.7 %), and far below the effect of any mistake. */
inline constexpr double kSameMotion = 0.02;

/** Lets `oracle` simulate a few small worlds, and compares the motions with those of
 `reference`, an engine that is right about free motion. Where they differ, finds the
 mistakes of WorldMistakes() by which the reference moves alike. */
std::vector<WorldCheck> CheckWorlds(const Oracle& oracle, const Oracle& reference);

}  // namespace touchstone
