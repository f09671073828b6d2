#pragma once

#include <vector>

#include <Eigen/Core>

#include "scenarios/contact_query.h"

namespace touchstone {

/** An orthographic view. A point of the world is drawn at its coordinates along `right_W`
 and `up_W` from `centre_W`, in units of `half_width`. */
struct View {
  Eigen::Vector3d right_W;   ///< Unit vector.
  Eigen::Vector3d up_W;      ///< Unit vector perpendicular to `right_W`.
  Eigen::Vector3d centre_W;  ///< Centre of the picture. [m]
  double half_width;         ///< Half width of the picture [-1, 1]², > 0. [m]

  /** Returns the position of `p_W` in the picture. [-] */
  Eigen::Vector2d operator*(const Eigen::Vector3d& p_W) const {
    const Eigen::Vector3d p = (p_W - centre_W) / half_width;
    return {right_W.dot(p), up_W.dot(p)};
  }
};

using Polyline = std::vector<Eigen::Vector2d>;

/** Returns the outline of `body` in `view`, counter-clockwise and not clipped. Curved
 outlines are sampled, most densely near ±`n_W`, where they are magnified. A half-space
 fills the picture up to its edge. */
Polyline OutlineOf(const Body& body, const View& view, const Eigen::Vector3d& n_W);

/** Returns the visible lines inside the outline: edges of a box that face the viewer,
 rims of cylinders and cones. Empty for other shapes. */
std::vector<Polyline> InnerLinesOf(const Body& body, const View& view);

/** Returns the part of the convex polygon `outline` inside the picture plus a small
 border. */
Polyline ClipToPicture(const Polyline& outline);

/** Returns the parts of the open `line` inside the picture plus a small border. */
std::vector<Polyline> ClipLineToPicture(const Polyline& line);

}  // namespace touchstone
