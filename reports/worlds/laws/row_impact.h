#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Spheres on a line hit each other along it; each pair leaves with e times the speed it
 came with (truth/row_of_balls.h). [m/s], [m]

 Where balls touch, impacts one after another and all at once are both legal; the first is
 the law's own truth, the other is recognised: "simultaneous impacts". So is either where
 gaps are shorter than the way of a step, V h. Of impacts one after another the order may
 be any: they are tried from the first ball and from the last.

 Velocities are right to the solver's residual, 1e-5 of the fastest, but for each ball
 around its impacts: the n-th of a row is up to n h late, or more where slower balls have
 to make up for that. Positions are off by n h times what the impacts changed, Σ |Δv|,
 × 1.5. Plus 64 roundings a step.

 About: spheres in the order of the line, no gravity, force or spin. Numbers:
 expected_first_velocity and expected_last_velocity, along the line from the first to the
 last, after the last impact, one after another; expected_simultaneous_first_velocity and
 expected_simultaneous_last_velocity. */
extern const Law kRowImpact;

}  // namespace touchstone
