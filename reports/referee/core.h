#pragma once

#include <span>
#include <variant>

#include <Eigen/Core>

#include "reports/referee/bounded.h"
#include "reports/referee/vector.h"
#include "scenarios/contact_query.h"

namespace touchstone::referee {

/** The body origin: what is left of a sphere. */
struct Point {};

/** The axis of a capsule. */
struct Segment {
  double half_length;  ///< [m]
};

/** The vertices of a hull, seen. */
using Vertices = std::span<const Eigen::Vector3d>;

/** A bounded shape without its rounding radius. */
using Core = std::variant<Point, Segment, Box, Vertices, Cylinder, Cone>;

/** A placed core with the radius of the ball that is swept over it. The truth is asked of
 the affine image R x + p of the core under the doubles of the pose; the ball stays a
 ball. */
struct RoundedCore {
  Core core;
  double radius;  ///< [m], >= 0
  Pose X_WB;      ///< Of the body.
};

/** Returns what `body` is made of. It refers to the vertices of `body`, which must
 outlive it.
 @pre `body` is not a half-space. */
RoundedCore CoreOf(const Body& body);

/** Returns true for cylinders and cones, whose boundary is not made of flat faces. */
bool IsCurved(const Core& core);

/** Returns the largest distance of a point of the core from the body origin, to rounding.
 * [m] */
double CoreRadius(const Core& core);

/** Returns n · x maximised over the core, in its body frame. The length of n scales it.
 */
template <typename Real>
Bounded<Real> SupportValue(const Core& core, const Vector<Bounded<Real>>& n);

/** Returns a point that certainly lies in the core, and is farthest along n up to
 * rounding. */
template <typename Real>
Vector<Real> SupportPoint(const Core& core, const Vector<Real>& n);

}  // namespace touchstone::referee
