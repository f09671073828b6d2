#pragma once

#include <string>

#include "scenarios/worlds/world.h"

namespace touchstone {

/** The coefficients of friction and restitution with which DART's combination rules yield
 the same results as Touchstone's.

 DART takes the smaller friction of two bodies and the product of their restitutions, and
 has no option for another rule. Suppose that all moving bodies have one e and one μ. Then
 the coefficients below yield min(e, e_S) and √(μ μ_S) against a static body S, and e and
 μ between moving bodies:

 | body   | restitution        | friction                                     |
 |--------|--------------------|----------------------------------------------|
 | moving | √e                 | μ; unbounded if it is the only moving body   |
 | static | min(e, e_S) / √e   | √(μ μ_S), at most μ unless only one moves    |

 Bodies that do not collide are ignored. */
class DartSurfaces {
 public:
  explicit DartSurfaces(const World& world);

  /** The reason why this world has no such coefficients; empty if it has. */
  const std::string& why_not() const { return why_not_; }

  double RestitutionOf(const RigidBody& body) const;
  double FrictionOf(const RigidBody& body) const;

 private:
  double restitution_ = 0;  ///< e of all moving bodies.
  double friction_ = 0;     ///< μ of all moving bodies.
  int moving_ = 0;
  std::string why_not_;
};

}  // namespace touchstone
