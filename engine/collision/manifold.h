#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <Eigen/Core>

namespace cookbook {

/** Which features of the two shapes make a contact: equal from step to step for as long
 as the same features meet, so that a solver can start from the impulse it found last
 time. Opaque; engine/collision/feature.h says how it is made. */
using FeatureId = std::uint32_t;

/** One contact. */
struct ContactPoint {
  /** On the plane midway through the overlap at this contact: p_WC ∓ n_AB_W separation /
   2 lie on the surfaces of A (−) and B (+), to rounding. World frame, [m]. */
  Eigen::Vector3d p_WC;
  /** Signed gap along the normal at this contact: < 0 penetrating. Never less than the
   manifold's; a contact of a slightly tilted face may be shallower. [m] */
  double separation;
  FeatureId feature;  ///< Unique within the manifold.
};

/** How two shapes touch: one normal and up to eight contacts that share it. A plain
 value: a query allocates nothing. */
struct Manifold {
  bool touching = false;  ///< Zero separation counts as touching.
  int count = 0;          ///< Of valid entries in `contacts`; 0 where apart.
  /** Unit, out of A into B: moving B by −separation · n_AB_W just separates the shapes.
   World frame. Where apart, the normal of a plane between the shapes. */
  Eigen::Vector3d n_AB_W;
  /** Touching: minus the depth, which is the length of the shortest translation that
   separates. Apart: the gap along n_AB_W. With a sphere in the pair that gap is the
   distance; for two boxes it is a lower bound of the distance and no more, since the
   search stops at the first axis that separates. [m] */
  double separation;
  std::array<ContactPoint, 8> contacts;  ///< The first `count` are valid.

  /** Returns the valid contacts. */
  std::span<const ContactPoint> points() const {
    return std::span(contacts).first(static_cast<std::size_t>(count));
  }
};

}  // namespace cookbook
