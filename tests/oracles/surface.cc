#include "tests/oracles/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenarios/convex_facets.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

struct Height {
  Vector3d p;  // Body frame.

  double rho() const { return std::hypot(p.x(), p.y()); }

  double operator()(const Sphere& s) const { return p.norm() - s.radius; }
  double operator()(const Box& s) const {
    return (p.cwiseAbs() - s.half_extents).maxCoeff();
  }
  double operator()(const Capsule& s) const {
    const double along = std::clamp(p.z(), -s.half_length, s.half_length);
    return (p - along * Vector3d::UnitZ()).norm() - s.radius;
  }
  double operator()(const Cylinder& s) const {
    return std::max(rho() - s.radius, std::abs(p.z()) - s.half_length);
  }
  double operator()(const Cone& s) const {
    // The flank's outward normal in the (rho, z) half-plane is (2 h, r), normalised.
    const double flank =
        (2 * s.half_height * rho() + s.radius * (p.z() - s.half_height)) /
        std::hypot(2 * s.half_height, s.radius);
    return std::max(flank, -s.half_height - p.z());
  }
  double operator()(const ConvexHull& s) const {
    double height = -std::numeric_limits<double>::infinity();
    const ConvexFacets boundary = BoundaryOf(s).value();
    for (const ConvexFacet& facet : boundary.facets) {
      height = std::max(height, facet.n_B.dot(p) - facet.offset);
    }
    return height;
  }
  double operator()(const HalfSpace&) const { return p.z(); }
};

}  // namespace

double HeightAboveSurface(const Body& body, const Eigen::Vector3d& p_W) {
  const Vector3d p_B = body.X_WB.R_WB.transpose() * (p_W - body.X_WB.p_WB);
  return std::visit(Height{p_B}, body.shape);
}

}  // namespace touchstone
