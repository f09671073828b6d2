#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A body at rest stays where it is. [m], [m/s]

 Motion: the displacement of the centre plus the radius times the angle of rotation, since
 the time `from`. An engine that detects a contact once per step lets the body fall 2 g h²
 before the contact resists. So does each contact that carries it, at most as many as the
 claim has subjects: × 1.5. A solver that does not converge leaves a velocity of 1e-5 g h.
 An overlap at the start, of a body and those it is piled with, may be resolved. Once what
 is left of it is at most what a step lets the bodies fall, they rest where they are. The
 author may grant more by `slack`. 64 roundings per step are added. Velocity: that of the
 same motion in one step; 2 n g h × 1.5 for the settling.

 About: bodies, particles and cloths that rest from `from` on; the author vouches that
 they can. Numbers: from [s], 0 if absent; slack [m]. */
extern const Law kRests;

}  // namespace touchstone
