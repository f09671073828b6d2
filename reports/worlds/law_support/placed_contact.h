#pragma once

#include <Eigen/Core>

#include "oracles/trajectory.h"
#include "reports/worlds/law_support/surface_line.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** A contact with its bodies where they are at the start of its step. */
struct PlacedContact {
  const ContactImpulse& contact;
  const Body& A;
  const Body& B;
  Eigen::Vector3d n_W;  ///< The contact's normal, normalised.
  double turn_A;        ///< By which A may turn within the step. [rad]
  double turn_B;        ///< By which B may.
  /** How far the surfaces of A and of B are off, over the error: the speed of each over
   that of the faster. 0 for a static body. */
  double share_A;
  double share_B;
  double rounding;  ///< By which the surface of a static body may be off. [m]

  /** Returns the least error within which it is true: the least `error` [m] such that
   surfaces within their share of it of their place have this contact, to one in 10^6; at
   most `most`. No
   motion of the other body brings a point out of a static one: then both move alike. */
  double LeastError(double most) const;

  /** Returns the least error within which `n_W` is the normal of a sphere with a sphere
   or a box; 0 for other pairs. The vector from the nearest point of a convex body to a
   point moves no more than the point does: so the two move by the distance of that vector
   from the ray along the normal. */
  double LeastErrorOfNormal() const;

  /** Returns what a turn of the box grants to LeastErrorOfNormal(): its nearest point is
   on its surface, at most the length of the vector from the centre, and turns it too. */
  double TurnOfNormal() const;

 private:
  /** The contact's line along the normal and against it, in the frames of the bodies. */
  struct Lines {
    BodyLine out_of_A;
    BodyLine out_of_B;
  };

  /** Returns whether it is true of surfaces that are within their share of `error` [m] of
   their place. */
  bool IsTrueWithin(double error, const Lines& lines) const;

  /** LeastError() with the shares as they are. */
  double LeastTrueError(double most, const Lines& lines) const;
};

}  // namespace touchstone
