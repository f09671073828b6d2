#include "reports/referee/proved_farther.h"

#include <cmath>
#include <variant>

#include "reports/referee/core.h"
#include "reports/referee/minkowski_difference.h"

namespace touchstone::referee {
namespace {

/** Returns the point of a core nearest to `q`, in its body frame, to rounding; `q` itself
 for the other cores, of which the caller's normal alone is tried. [m] */
struct RoughlyNearest {
  const Eigen::Vector3d& q;

  Eigen::Vector3d operator()(const Point&) const { return Eigen::Vector3d::Zero(); }
  Eigen::Vector3d operator()(const Segment& segment) const {
    return {0, 0, std::fmax(-segment.half_length, std::fmin(q.z(), segment.half_length))};
  }
  Eigen::Vector3d operator()(const Box& box) const {
    return q.cwiseMin(box.half_extents).cwiseMax(-box.half_extents);
  }
  template <typename Other>
  Eigen::Vector3d operator()(const Other&) const {
    return q;
  }
};

/** Returns whether the plane of the body's support along n proves the distance: n · p
 exceeds the support value by more than |n| times the distance and the core's radius. */
bool Proves(const RoundedCore& placed, const Eigen::Vector3d& p_W,
            const Eigen::Vector3d& n_W, double distance) {
  using Number = Bounded<double>;
  const Vector<Number> n = Exactly<Number>(n_W);
  const Vector<Number> from_origin =
      Exactly<Number>(p_W) - Exactly<Number>(placed.X_WB.p_WB);
  const Number gap =
      Dot(n, from_origin) - SupportValue(placed.core, RotateBack(placed.X_WB.R_WB, n));
  const Number least = (Number(distance) + Number(placed.radius)) * Norm(n);
  return (gap - least).enclosure().lo > 0;
}

}  // namespace

bool IsProvedFarther(const Body& body, const Eigen::Vector3d& p_W,
                     const Eigen::Vector3d& n_W, double distance) {
  if (KindOf(body.shape) == ShapeKind::kHalfSpace) return false;
  const RoundedCore placed = CoreOf(body);
  if (Proves(placed, p_W, n_W, distance)) return true;
  const Eigen::Vector3d q = placed.X_WB.R_WB.transpose() * (p_W - placed.X_WB.p_WB);
  const Eigen::Vector3d outwards = q - std::visit(RoughlyNearest{q}, placed.core);
  return !outwards.isZero(0) &&
         Proves(placed, p_W, placed.X_WB.R_WB * outwards, distance);
}

}  // namespace touchstone::referee
