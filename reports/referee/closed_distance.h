#pragma once

#include <optional>

#include <Eigen/Core>

#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone::referee {

/** Returns an enclosure of SignedDistance() by closed forms in double-double. Empty for
 hulls, and where the forms do not give it to within a rounding of the scene or 2^-47 of
 itself: bodies too large or small for the exponents of doubles, matrices far from a
 rotation. [m] */
std::optional<Enclosure> ClosedDistance(const Body& body, const Eigen::Vector3d& p_W);

}  // namespace touchstone::referee
