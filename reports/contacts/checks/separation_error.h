#pragma once

#include "reports/referee/contact_truth.h"

namespace touchstone {

class JudgedAnswer;

/** Returns |separation − truth|, as far as the enclosure of the truth proves it. [m] The
 signed separation of convex sets A and B is the distance of the origin from the boundary
 of their Minkowski difference, negative inside. Source: Cameron & Culley, "Determining
 the minimum translational distance between two convex polyhedra", ICRA 1986. */
double SeparationError(const ContactTruth& truth, double separation);

/** Judges the separation that the answer states. */
void CheckSeparation(JudgedAnswer& judged);

}  // namespace touchstone
