#pragma once

#include "reports/referee/double_double.h"
#include "reports/referee/vector.h"
#include "scenarios/contact_query.h"

namespace touchstone::referee {

/** A direction that is no unit vector, with twice the digits of a double: a face of a
 plank of 2 m by 1 mm appears tilted along one that is rounded to doubles. */
using FineDirection = Vector<DoubleDouble>;

/** Returns the unit vector nearest to `direction`. */
Eigen::Vector3d Rounded(const FineDirection& direction);

/** Returns the direction from A to B near the unit vector `n_W` along which the features
 of both bodies within `slack` [m] of their supporting planes are flat. It is
 perpendicular to the longest edge of these features, and to the one that spans the widest
 plane with it, if that is wider than `slack`; without such edges it is n_W itself. The
 normal of a half-space is perpendicular to its axes x and y. */
FineDirection FlatDirection(const ContactQuery& query, const Eigen::Vector3d& n_W,
                            double slack);

/** Returns whether the feature of `body` within `e` of its supporting plane along
 `direction` does not lie flat to within `flush`. Its heights are computed in twice the
 digits, so that neither is widened by a rounding. [m] */
bool IsTilted(const Body& body, const FineDirection& direction, double flush, double e);

}  // namespace touchstone::referee
