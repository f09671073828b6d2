#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <Eigen/Core>

namespace cookbook {

/** The identity of a contact: which features of the two shapes make it. It stays the same
 from step to step while the same features touch, so that a solver can warm-start from
 its previous impulse. Opaque; engine/collision/feature.h defines the encoding. */
using FeatureId = std::uint32_t;

/** One point of a contact manifold. */
struct ContactPoint {
  /** Midway through the overlap at this contact: p_WC ∓ n_AB_W separation / 2 lie on the
   surfaces of A (−) and B (+), to rounding. World frame. [m] */
  Eigen::Vector3d p_WC;
  /** Signed gap along the normal at this contact, < 0 if penetrating. Never less than the
   manifold's separation; a contact of a slightly tilted face may be shallower. [m] */
  double separation;
  FeatureId feature;  ///< Unique within the manifold.
};

/** A contact manifold: one normal and up to eight contacts that share it. It is a plain
 value type: a query allocates nothing. */
struct Manifold {
  bool touching = false;  ///< True also at zero separation.
  int count = 0;          ///< Number of valid entries in `contacts`; 0 if apart.
  /** Unit normal out of A into B: moving B by −separation · n_AB_W just separates the
   shapes. If apart, the normal of a separating plane. World frame. */
  Eigen::Vector3d n_AB_W;
  /** If touching: minus the depth, the length of the shortest translation that separates
   the shapes. If apart: the gap along n_AB_W. With a sphere in the pair that gap is the
   distance. For two boxes it is only a lower bound of the distance, since the search
   stops at the first separating axis. [m] */
  double separation;
  std::array<ContactPoint, 8> contacts;  ///< The first `count` are valid.

  /** Returns the valid contacts. */
  std::span<const ContactPoint> points() const {
    return std::span(contacts).first(static_cast<std::size_t>(count));
  }
};

}  // namespace cookbook
