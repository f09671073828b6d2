#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** The linear momentum of an isolated system is changed only by external forces and
 pushes: P(t) = P(0) + t Σ (m g + F) + Σ J. [N s]

 Contacts, springs and joints within the system apply equal and opposite impulses, for any
 step and however badly they are solved. Every scheme integrates a constant force exactly.
 So the tolerance is rounding alone.

 About: bodies, particles and cloths that nothing else holds. Numbers: x, y, z, a
 direction along which momentum is conserved if the rest is not (a frictionless floor); if
 absent, all of it is. expected_momentum: |P(0)|. */
extern const Law kConservesMomentum;

}  // namespace touchstone
