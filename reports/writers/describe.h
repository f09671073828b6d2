#pragma once

#include <string>

#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns "(x, y, z)" to six digits. */
std::string Describe(const Eigen::Vector3d& v);

/** Returns the shape, its sizes and its place: "sphere, radius 0.5 m at (1.2, 0, 0)". */
std::string Describe(const Body& body);

/** Returns the truth and its certificate as a sentence. */
std::string Describe(const ContactTruth& truth);

/** Returns the least error of `separation` that the enclosure of the truth leaves
 possible; NaN for NaN. [m] */
double LeastError(double separation, const ContactTruth& truth);

}  // namespace touchstone
