#pragma once

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Spheres on a line hit each other along it; each pair leaves an impact with e times its
 closing speed (truth/row_of_balls.h). [m/s], [m]

 If several balls touch, sequential and simultaneous impacts are both legal. The first is
 the law's own truth; the other is recognised as "simultaneous impacts". Either is
 recognised too if gaps are shorter than the distance covered in a step, V h. Sequential
 impacts may have any order: they are tried from the first ball and from the last.

 Velocities are exact to the solver's residual, 1e-5 of the fastest, except around each
 ball's impacts: the n-th of a row is up to n h late, or more if slower balls have to make
 up for that. Positions are off by n h times the total velocity change by impacts, Σ |Δv|,
 × 1.5. 64 roundings per step are added.

 About: spheres in the order of the line, without gravity, force or spin. Numbers:
 expected_first_velocity and expected_last_velocity, along the line from the first to the
 last, after the last impact, for sequential impacts; expected_simultaneous_first_velocity
 and expected_simultaneous_last_velocity. */
extern const Law kRowImpact;

}  // namespace touchstone
