#include "oracles/fcl/fcl_geometry.h"

#include <optional>
#include <variant>
#include <vector>

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/sphere.h>

#include "scenarios/convex_facets.h"

namespace touchstone {
namespace {

using Geometry = std::shared_ptr<const fcl::CollisionGeometry<double>>;

struct MakeGeometry {
  Geometry operator()(const Sphere& s) const {
    return std::make_shared<fcl::Sphered>(s.radius);
  }
  Geometry operator()(const Box& s) const {
    return std::make_shared<fcl::Boxd>(2 * s.half_extents);
  }
  Geometry operator()(const Capsule& s) const {
    return std::make_shared<fcl::Capsuled>(s.radius, 2 * s.half_length);
  }
  Geometry operator()(const Cylinder& s) const {
    return std::make_shared<fcl::Cylinderd>(s.radius, 2 * s.half_length);
  }
  Geometry operator()(const Cone& s) const {
    return std::make_shared<fcl::Coned>(s.radius, 2 * s.half_height);
  }
  Geometry operator()(const ConvexHull& s) const {
    const std::optional<ConvexFacets> boundary = BoundaryOf(s);
    if (!boundary) return nullptr;
    auto faces = std::make_shared<std::vector<int>>();
    for (const ConvexFacet& facet : boundary->facets) {
      faces->push_back(static_cast<int>(facet.corners.size()));
      faces->insert(faces->end(), facet.corners.begin(), facet.corners.end());
    }
    return std::make_shared<fcl::Convexd>(
        std::make_shared<const std::vector<Eigen::Vector3d>>(boundary->corners),
        static_cast<int>(boundary->facets.size()), faces);
  }
  Geometry operator()(const HalfSpace&) const {
    return std::make_shared<fcl::Halfspaced>(Eigen::Vector3d::UnitZ(), 0.0);
  }
};

FclBody ToFcl(const Body& body) {
  FclBody result{std::visit(MakeGeometry{}, body.shape), Eigen::Isometry3d::Identity()};
  result.X_WB.linear() = body.X_WB.R_WB;
  result.X_WB.translation() = body.X_WB.p_WB;
  return result;
}

}  // namespace

FclPair ToFcl(const ContactQuery& query) {
  return {ToFcl(query.A), ToFcl(query.B)};
}

}  // namespace touchstone
