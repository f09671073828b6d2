#include "oracles/ode/ode_geom.h"

#include <algorithm>
#include <optional>
#include <variant>

#include <ode/ode.h>

#include "scenarios/convex_facets.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

struct MakePrimitive {
  dGeomID operator()(const Sphere& s) const { return dCreateSphere(nullptr, s.radius); }
  dGeomID operator()(const Box& s) const {
    const Vector3d sides = 2 * s.half_extents;
    return dCreateBox(nullptr, sides.x(), sides.y(), sides.z());
  }
  dGeomID operator()(const Capsule& s) const {
    return dCreateCapsule(nullptr, s.radius, 2 * s.half_length);
  }
  dGeomID operator()(const Cylinder& s) const {
    return dCreateCylinder(nullptr, s.radius, 2 * s.half_length);
  }
  dGeomID operator()(const Cone&) const { return nullptr; }
  dGeomID operator()(const ConvexHull&) const { return nullptr; }
  dGeomID operator()(const HalfSpace&) const { return nullptr; }
};

}  // namespace

void OdeGeom::Destroy::operator()(dxGeom* geom) const {
  dGeomDestroy(geom);
}

OdeGeom::OdeGeom(const Body& body) {
  const Eigen::Matrix3d& R = body.X_WB.R_WB;
  const Vector3d& p = body.X_WB.p_WB;
  if (std::holds_alternative<HalfSpace>(body.shape)) {
    // A plane has no pose: its equation is n·x = d in the world.
    const Vector3d n_W = R.col(2);
    geom_.reset(dCreatePlane(nullptr, n_W.x(), n_W.y(), n_W.z(), n_W.dot(p)));
    return;
  }
  if (const auto* hull = std::get_if<ConvexHull>(&body.shape)) {
    MakeConvex(*hull);
  } else {
    geom_.reset(std::visit(MakePrimitive{}, body.shape));
  }
  if (!geom_) return;
  const dMatrix3 rows = {R(0, 0), R(0, 1), R(0, 2), 0,  //
                         R(1, 0), R(1, 1), R(1, 2), 0,  //
                         R(2, 0), R(2, 1), R(2, 2), 0};
  dGeomSetRotation(geom_.get(), rows);
  const Vector3d origin_W = p + R * origin_B_;
  dGeomSetPosition(geom_.get(), origin_W.x(), origin_W.y(), origin_W.z());
}

void OdeGeom::AttachTo(dxBody* body) {
  dGeomSetBody(geom_.get(), body);
  if (!origin_B_.isZero(0))
    dGeomSetOffsetPosition(geom_.get(), origin_B_.x(), origin_B_.y(), origin_B_.z());
}

void OdeGeom::MakeConvex(const ConvexHull& hull) {
  const std::optional<ConvexFacets> boundary = BoundaryOf(hull);
  if (!boundary) return;
  // ODE requires the geom's origin to be inside the hull: MPR starts its search there.
  const bool origin_is_inside = std::ranges::all_of(
      boundary->facets, [](const ConvexFacet& facet) { return facet.offset > 0; });
  if (!origin_is_inside) origin_B_ = boundary->centre;
  for (const Vector3d& corner : boundary->corners) {
    const Vector3d x = corner - origin_B_;
    points_.insert(points_.end(), {x.x(), x.y(), x.z()});
  }
  for (const ConvexFacet& facet : boundary->facets) {
    const Vector3d& n = facet.n_B;
    planes_.insert(planes_.end(), {n.x(), n.y(), n.z(), facet.offset - n.dot(origin_B_)});
    polygons_.push_back(static_cast<unsigned>(facet.corners.size()));
    for (const int corner : facet.corners)
      polygons_.push_back(static_cast<unsigned>(corner));
  }
  geom_.reset(dCreateConvex(
      nullptr, planes_.data(), static_cast<unsigned>(boundary->facets.size()),
      points_.data(), static_cast<unsigned>(boundary->corners.size()), polygons_.data()));
}

}  // namespace touchstone
