#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** A body's angular momentum about its centre c changes by the moments of the pushes and
 of the contact impulses that the engine reports:

    Δ(R I Rᵀ ω) = Σ (p − c) × J.  [N m s]

 Gravity and the body's force act at c. The points p are those that the engine reports.
 Nobody tells where c was when the contacts acted. It is taken where it explains most on
 three ways: straight from sample to sample; and if these are a step h apart, on from the
 first at its velocity, and back from the second. The tolerance is what a legal scheme may
 differ by, × 1.5, at speeds that the truth allows:

 - levers: |v| (Δt − h)/2 |J|, since c may leave the straight way between distant samples;
   V h |J| and |s| |J|, since p may be a point on either body at the start or at the end
   of its step. V is |v| + |ω| R, for a sphere |v|, and s the separation;
 - the gyroscopic term: h ∫ |ω × (ω × L)| (law_support/scheme_drift.h), and h (|ω| |ΔL| +
   |Δω| |L|), since it acts on the spin before or after the impulses. Zero for bodies with
   equal moments of inertia;
 - position correction: it may turn the body by |s|/|p − c| and leave ω, which changes L
 by that share. Zero for the same bodies.

 Rounding is that of momentum_balance, with the levers; and 64 roundings of I |ω| for
 the momentum at either sample. An engine that takes spins from orientations knows them to
 u/h, so I u/h is granted at rest too, as NoiseOfPositions() (truth/mechanics.h) of
 places. Judges only engines that report contact impulses. About: bodies that no spring or
 joint holds. Numbers: none. */
extern const Law kAngularMomentumBalance;

}  // namespace touchstone
