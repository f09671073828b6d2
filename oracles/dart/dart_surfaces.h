#pragma once

#include <string>

#include "scenarios/worlds/world.h"

namespace touchstone {

/** The friction and restitution that make DART's rules give Touchstone's.

 DART takes the smaller friction of two bodies and the product of their restitutions, and
 cannot be told another rule. Where all that moves has one e and one μ, this gives
 min(e, e_S) and √(μ μ_S) against whatever stands still, and e and μ among themselves:

 |        | restitution        | friction                                     |
 |--------|--------------------|----------------------------------------------|
 | moves  | √e                 | μ; without bound, if it is the only one      |
 | stands | min(e, e_S) / √e   | √(μ μ_S), which must then be at most μ       |

 Bodies that do not collide do not count. */
class DartSurfaces {
 public:
  explicit DartSurfaces(const World& world);

  /** Why this world has no such surfaces; empty: it has. */
  const std::string& why_not() const { return why_not_; }

  double RestitutionOf(const RigidBody& body) const;
  double FrictionOf(const RigidBody& body) const;

 private:
  double restitution_ = 0;  ///< e, of all that moves.
  double friction_ = 0;     ///< μ, of all that moves.
  int moving_ = 0;
  std::string why_not_;
};

}  // namespace touchstone
