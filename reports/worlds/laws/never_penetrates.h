#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Bodies that collide never penetrate deeper than they can move in one step. [m]

 A contact that is first detected at the end of a step is at most V h deep, where V is the
 speed at which the surfaces approach there. A load adds up to 2 a h² before the contact
 resists, with a = |g + F/m|; an engine need not undo that. The tolerance is 1.5 times
 that depth, and 64 roundings per step. A penetration at the start is granted. The depth
 is the referee's, certified. V h is granted for two steps after an arrival. Later
 the least depth since then takes its place (law_support/allowed_depth.h).

 V is taken at the deepest point and along the direction of the depth: |n·u_A| + |n·u_B|
 with u = v + ω × r, at the sample and at the one before, and the largest since the pair
 was apart. So sliding and spin about the normal do not enlarge the tolerance. The two
 speeds are added, not subtracted, since an impact may stop one of two bodies that move
 together. No speed is larger than the truth allows (law_support/allowed_motion.h).

 Between samples that are further apart than a step, a body may turn: its |n × ω| |r|
 counts in full, and gravity over that time. If it may also touch a third body meanwhile,
 that may transfer its own speed, so the |v| + |ω| |r| of the fastest body counts.

 About: bodies; pairs of which at least one is named. Numbers: slack [m], granted on top,
 with its reason in the claim's `because`; parted_by [s], the time from which a
 penetration at the start is no longer granted. */
extern const Law kNeverPenetrates;

}  // namespace touchstone
