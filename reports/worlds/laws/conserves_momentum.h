#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** The linear momentum of things that only act on each other changes by what acts from
 outside and by nothing else: P(t) = P(0) + t Σ (m g + F) + Σ J. [N s]

 Contacts, springs and joints among them give equal and opposite impulses, whatever the
 step and however badly they are solved; every scheme integrates a constant force exactly.
 So rounding is all that may be off.

 About: bodies, particles and cloths that nothing else holds. Numbers: x, y, z, a
 direction along which momentum is kept where the rest is not (a frictionless floor);
 absent, all of it. expected_momentum: |P(0)|. */
extern const Law kConservesMomentum;

}  // namespace touchstone
