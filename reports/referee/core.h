#pragma once

#include <span>
#include <variant>

#include <Eigen/Core>

#include "reports/referee/bounded.h"
#include "reports/referee/vector.h"
#include "scenarios/contact_query.h"

namespace touchstone::referee {

/** The core of a sphere: the body origin. */
struct Point {};

/** The core of a capsule: its axis. */
struct Segment {
  double half_length;  ///< [m]
};

/** A view of the vertices of a hull. */
using Vertices = std::span<const Eigen::Vector3d>;

/** A bounded shape without its rounding radius. */
using Core = std::variant<Point, Segment, Box, Vertices, Cylinder, Cone>;

/** A placed core with the radius of the ball that is swept over it. The truth refers to
 the affine image R x + p of the core for the exact doubles of the pose. The ball is not
 transformed. */
struct RoundedCore {
  Core core;
  double radius;  ///< Radius of the ball, >= 0. [m]
  Pose X_WB;      ///< Pose of the body.
};

/** Returns the rounded core of `body`. It refers to the vertices of `body`, which must
 outlive it.
 @pre `body` is not a half-space. */
RoundedCore CoreOf(const Body& body);

/** Returns true for a cylinder or a cone, whose boundary has curved faces. */
bool IsCurved(const Core& core);

/** Returns the largest distance of a point of the core from the body origin, to rounding.
 [m] */
double CoreRadius(const Core& core);

/** Returns the maximum of n · x over the core, in its body frame. It scales with the
 length of n. */
template <typename Real>
Bounded<Real> SupportValue(const Core& core, const Vector<Bounded<Real>>& n);

/** Returns a point that certainly lies in the core and is farthest along n up to
 rounding. */
template <typename Real>
Vector<Real> SupportPoint(const Core& core, const Vector<Real>& n);

}  // namespace touchstone::referee
