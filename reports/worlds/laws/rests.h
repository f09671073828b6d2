#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** What rests stays where it is. [m], [m/s]

 Motion: the way of the centre plus the radius times the angle turned, from where it was
 at the time `from`. An engine that sees a contact once a step lets it fall 2 g h² before
 it resists, and so does each of the contacts that carry it, at most as many as the claim
 has subjects: × 1.5. A solver that stops short leaves 1e-5 of g h a step. What a body
 and those it is heaped with overlap at the start may be resolved, until they are parted
 to within what a step lets them fall: from then on they rest where they are. The author
 may grant more: `slack`. Plus 64 roundings a step. Velocity: that of a step of the same,
 2 n g h, × 1.5.

 About: bodies, particles and cloths that rest from `from` on; that they can is the
 author's word. Numbers: from [s], 0 where absent; slack [m]. */
extern const Law kRests;

}  // namespace touchstone
