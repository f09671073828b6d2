#include "scenarios/worlds/solid.h"

#include <cstddef>
#include <numbers>
#include <variant>

#include <Eigen/Geometry>

#include "scenarios/convex_facets.h"

namespace touchstone {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

using std::numbers::pi;

Solid Centred(double volume, const Vector3d& moments) {
  return {volume, Vector3d::Zero(), moments.asDiagonal()};
}

/** Sums over the tetrahedra between the faces and a point inside. */
std::optional<Solid> SolidOf(const ConvexFacets& boundary, double mass) {
  double six_volumes = 0;
  Vector3d first = Vector3d::Zero();   // 24 ∫ x dV
  Matrix3d second = Matrix3d::Zero();  // 120 ∫ x xᵀ dV
  const auto corner = [&](const ConvexFacet& facet, std::size_t i) -> Vector3d {
    return boundary.corners[static_cast<std::size_t>(facet.corners[i])] - boundary.centre;
  };
  for (const ConvexFacet& facet : boundary.facets) {
    const Vector3d a = corner(facet, 0);
    for (std::size_t i = 1; i + 1 < facet.corners.size(); ++i) {
      const Vector3d b = corner(facet, i);
      const Vector3d c = corner(facet, i + 1);
      const double det = a.dot(b.cross(c));
      const Vector3d sum = a + b + c;
      six_volumes += det;
      first += det * sum;
      second += det * (sum * sum.transpose() + a * a.transpose() + b * b.transpose() +
                       c * c.transpose());
    }
  }
  if (!(six_volumes > 0)) return std::nullopt;
  const Vector3d centre = first / (4 * six_volumes);
  const Matrix3d spread = second / (20 * six_volumes) - centre * centre.transpose();
  return Solid{six_volumes / 6, boundary.centre + centre,
               mass * (spread.trace() * Matrix3d::Identity() - spread)};
}

struct Fill {
  using Result = std::optional<Solid>;

  double mass;

  Result operator()(const Sphere& s) const {
    const double r = s.radius;
    return Centred(pi * 4 / 3 * r * r * r, Vector3d::Constant(0.4 * mass * r * r));
  }
  Result operator()(const Box& s) const {
    const Vector3d squares = s.half_extents.cwiseAbs2();
    return Centred(8 * s.half_extents.prod(),
                   mass / 3 * (Vector3d::Constant(squares.sum()) - squares));
  }
  Result operator()(const Capsule& s) const {
    // A cylinder of volume 2 π r² a between two halves of a ball of volume 4/3 π r³. The
    // centre of mass of each half is 3/8 r beyond its end of the cylinder.
    const double r = s.radius;
    const double a = s.half_length;
    const double tube = mass * 3 * a / (3 * a + 2 * r);
    const double ball = mass - tube;
    const double along = tube * r * r / 2 + ball * 0.4 * r * r;
    const double across =
        tube * (r * r / 4 + a * a / 3) + ball * (0.4 * r * r + a * a + 0.75 * a * r);
    return Centred(pi * r * r * (2 * a + 4 * r / 3), {across, across, along});
  }
  Result operator()(const Cylinder& s) const {
    const double r = s.radius;
    const double a = s.half_length;
    const double across = mass * (r * r / 4 + a * a / 3);
    return Centred(2 * pi * r * r * a, {across, across, mass * r * r / 2});
  }
  Result operator()(const Cone& s) const {
    const double r = s.radius;
    const double a = s.half_height;
    const double across = mass * 0.15 * (r * r + a * a);
    const Vector3d moments(across, across, mass * 0.3 * r * r);
    return Solid{pi * 2 / 3 * r * r * a, {0, 0, -a / 2}, moments.asDiagonal()};
  }
  Result operator()(const ConvexHull& s) const {
    const std::optional<ConvexFacets> boundary = BoundaryOf(s);
    if (!boundary) return std::nullopt;
    return SolidOf(*boundary, mass);
  }
  Result operator()(const HalfSpace&) const { return std::nullopt; }
};

}  // namespace

std::optional<Solid> UniformSolid(const Shape& shape, double mass) {
  return std::visit(Fill{mass}, shape);
}

std::optional<Vector3d> UniformMoments(const Shape& shape, double mass) {
  const std::optional<Solid> solid = UniformSolid(shape, mass);
  if (!solid) return std::nullopt;
  // Compared by itself: the largest of several numbers need not be a NaN among them.
  if (!solid->inertia_B.allFinite()) return std::nullopt;
  const Vector3d moments = solid->inertia_B.diagonal();
  const Matrix3d moments_only = moments.asDiagonal();
  const double product = (solid->inertia_B - moments_only).cwiseAbs().maxCoeff();
  const double distance = solid->centre_B.norm();
  if (!(product <= kAligned * moments.maxCoeff())) return std::nullopt;
  if (!(distance <= kAligned * BoundingRadius(shape))) return std::nullopt;
  return moments;
}

}  // namespace touchstone
