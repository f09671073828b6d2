#pragma once

#include "oracles/contact_answer.h"
#include "scenarios/contact_query.h"

namespace touchstone {

class JudgedAnswer;

/** Returns | |p_B − p_A| − gap(n) | for n = (p_B − p_A) / |p_B − p_A|. [m] The support
 gap min_B n·x − max_A n·x is a lower bound on the distance, and |p_B − p_A| an upper one.
 Their difference is zero if and only if both points are nearest points. A negative
 difference means that the points are not on the shapes, which is an error as well.
 Source: Gilbert, Johnson & Keerthi, IEEE J. Robotics and Automation 4(2), 1988, theorem
 1.
 @pre The points are finite and differ. */
double DualityGap(const ContactQuery& query, const WitnessPoints& witnesses);

/** Judges the witness points of bodies that are apart. Points that coincide are judged by
 their distance from the surfaces. */
void CheckDualityGap(JudgedAnswer& judged);

}  // namespace touchstone
