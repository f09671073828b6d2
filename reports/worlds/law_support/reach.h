#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Where the bodies of a motion may be, by their bounding spheres: a broad phase for laws
 about pairs. It rules a pair out only
 if the two certainly never meet, up to a rounding. */
class Reach {
 public:
  explicit Reach(const Motion& motion);

  /** Returns whether A and B may touch on the straight ways between samples. The bounding
   boxes of their ways overlap, or a way comes as near to a half-space. */
  bool MayEverTouch(int A, int B) const;

  /** Returns whether A and B may touch at sample `s`. */
  bool MayTouch(std::size_t s, int A, int B) const;

 private:
  struct Bounds {
    bool is_half_space = false;
    bool is_static = false;
    double radius = 0;        ///< [m]
    Eigen::Vector3d p_W;      ///< Position of a static body. [m]
    Eigen::Vector3d n_W;      ///< Normal of a half-space.
    Eigen::AlignedBox3d way;  ///< All its points at all samples, except a half-space's.
  };

  const Eigen::Vector3d& CentreOf(std::size_t s, std::size_t body) const;

  /** Returns whether `body` may touch the half-space at sample `s`. */
  bool IsNearPlane(std::size_t s, const Bounds& plane, std::size_t body) const;

  Motion motion_;
  std::vector<Bounds> bounds_;  ///< Indexed by body.
};

/** Returns a bound on the way of any point of `body` from sample `s` to the next, at the
 velocity of that sample and under the body's loads. [m] */
double WayAfter(const Motion& motion, std::size_t s, int body);

}  // namespace touchstone
