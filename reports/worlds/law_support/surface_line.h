#pragma once

#include <optional>

#include <Eigen/Core>

#include "scenarios/contact_query.h"

namespace touchstone {

/** The part of a line inside a body, as an interval of its parameter. [m] */
struct Chord {
  double enters = 0;  ///< −∞ for a half-space that the line leaves.
  double leaves = 0;  ///< +∞ for a half-space that the line enters.
};

/** Returns whether ChordThrough() knows the shape: a sphere, a box or a half-space. */
bool HasChords(const Shape& shape);

/** Returns the part of the line p_W + t d_W that is inside `body` when the surface is
 moved outwards by `offset` [m], or inwards if that is negative; empty if there is none. A
 box keeps its corners: its faces are moved.
 @pre HasChords(body.shape) and |d_W| = 1. */
std::optional<Chord> ChordThrough(const Body& body, double offset,
                                  const Eigen::Vector3d& p_W, const Eigen::Vector3d& d_W);

/** A line p + t d in the frame of a body. */
struct BodyLine {
  Eigen::Vector3d p_Bo;  ///< From the origin of the body. [m]
  Eigen::Vector3d d_B;   ///< Unit.
};

/** Returns the line p_W + t d_W in the frame of a body. */
BodyLine SeenFrom(const Pose& X_WB, const Eigen::Vector3d& p_W,
                  const Eigen::Vector3d& d_W);

/** The same as above for a line in the frame of the body, which is found once for several
 offsets. */
std::optional<Chord> ChordThrough(const Shape& shape, double offset,
                                  const BodyLine& line);

}  // namespace touchstone
