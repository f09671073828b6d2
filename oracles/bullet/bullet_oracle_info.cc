#include "oracles/bullet/bullet_oracle_info.h"

#include <utility>

namespace touchstone {
namespace {

/** How closely Bullet's iterations converge, by its own constants. */
struct Convergence {
  double epa;  ///< EPA_ACCURACY in btGjkEpa2.cpp. [m]
  double gjk;  ///< REL_ERROR2 in btGjkPairDetector.cpp: a share of the distance.
};

Convergence ConvergenceOf(BulletPrecision precision) {
  return precision == BulletPrecision::kDouble ? Convergence{1e-12, 1e-12}
                                               : Convergence{1e-4, 1e-6};
}

Capability GjkEpa(const Convergence& convergence) {
  Capability capability;
  capability.supported = true;
  capability.family = "gjk_epa";
  capability.depth = true;
  capability.normal = true;
  capability.documented_error = convergence.epa;
  capability.documented_by = "EPA_ACCURACY, btGjkEpa2.cpp";
  return capability;
}

Capability Unsupported(std::string reason) {
  Capability capability;
  capability.reason = std::move(reason);
  return capability;
}

bool IsRound(ShapeKind kind) {
  return kind == ShapeKind::kSphere || kind == ShapeKind::kCapsule;
}

/* What btDefaultCollisionConfiguration::getCollisionAlgorithmCreateFunc() chooses, and
 the special cases within btConvexConvexAlgorithm::processCollision(). */
Capability WorldDispatchCapability(ShapeKind a, ShapeKind b, BulletPrecision precision) {
  const bool a_plane = a == ShapeKind::kHalfSpace;
  const bool b_plane = b == ShapeKind::kHalfSpace;
  if (a_plane && b_plane) return Unsupported("two planes have no contact algorithm");
  Capability capability = GjkEpa(ConvergenceOf(precision));
  const bool plane = a_plane || b_plane;  // btConvexPlaneCollisionAlgorithm
  const bool boxes = a == ShapeKind::kBox && b == ShapeKind::kBox;
  // All others find one point a call, which a stepped world gathers to a manifold over
  // several steps.
  capability.manifold = boxes;
  if (!plane && !boxes && !(IsRound(a) && IsRound(b))) return capability;
  // btBoxBoxDetector is adapted from ODE.
  capability.family = boxes ? "box_box_sat" : "closed_form";
  capability.documented_error = 0;
  capability.documented_by.clear();
  return capability;
}

Capability ClosestPointsCapability(ShapeKind a, ShapeKind b, BulletPrecision precision) {
  if (a == ShapeKind::kHalfSpace || b == ShapeKind::kHalfSpace) {
    return Unsupported("btGjkPairDetector takes convex shapes only; a plane is not one");
  }
  const Convergence convergence = ConvergenceOf(precision);
  Capability capability = GjkEpa(convergence);
  capability.distance = true;
  capability.witnesses = true;
  capability.documented_relative_error = convergence.gjk;
  capability.documented_by += "; REL_ERROR2, btGjkPairDetector.cpp";
  return capability;
}

std::vector<Setting> CommonSettings(BulletPrecision precision) {
  std::vector<Setting> settings = {
      {"scalar", precision == BulletPrecision::kDouble ? "double" : "float",
       "Debian ships both builds; sizes and poses are rounded to it."},
      {"normal", "B->A, negated", "The project's normals point from A to B."},
      {"separation", "Bullet's signed distance",
       "Negative penetrating, as in the project."},
      {"pose", "the rotation matrix itself", "A quaternion would round it once more."},
      {"box", "half extents, margin 0",
       "A margin rounds edges and corners in GJK; without it the size is kept."},
      {"cylinder", "btCylinderShapeZ, half extents, margin 0", "As for the box."},
      {"cone", "btConeShapeZ, full height, margin 0",
       "Bullet's cone is centred at half its height, too; a margin would enlarge it."},
      {"convex hull", "margin 0", "A margin would enlarge it by as much."},
      {"sphere, capsule", "margin = radius",
       "In Bullet the margin is what is round in them."},
  };
  return settings;
}

std::vector<Setting> WorldDispatchSettings() {
  return {
      {"algorithm", "BT_CONTACT_POINT_ALGORITHMS, run once on an empty manifold",
       "The path of a stepped world; box-box is btBoxBoxDetector."},
      {"contact position", "midway between the positions on A and on B",
       "The project's convention; Bullet gives both."},
      {"contacts apart", "not touching; the least distance is passed on",
       "A manifold also holds points up to the contact breaking threshold away."},
      {"contact breaking threshold", "0.02 times the shape's size, Bullet's default",
       "Points nearer to each other than this are one contact."},
      {"half-space", "btStaticPlaneShape, normal z", "One contact: the deepest vertex."},
      {"contacts per pair", "box-box up to 4, others 1",
       "Bullet adds further ones over the steps of a world; an oracle has no past."},
  };
}

std::vector<Setting> ClosestPointsSettings() {
  return {
      {"algorithm", "btGjkPairDetector with btGjkEpaPenetrationDepthSolver",
       "Bullet's closest points, without its contact manifold."},
      {"witnesses", "point on B as given, point on A = point on B + distance * normal",
       "As btManifoldResult does."},
  };
}

}  // namespace

OracleInfo BulletOracleInfo(BulletPrecision precision, BulletPath path,
                            const BulletModule& module) {
  const bool dispatch = path == BulletPath::kWorldDispatch;
  OracleInfo info;
  info.name = precision == BulletPrecision::kDouble ? "bullet" : "bullet_float";
  if (!dispatch) info.name += "/gjk";
  info.library = "Bullet";
  info.version =
      std::to_string(module.version / 100) + "." + std::to_string(module.version % 100);
  info.unit_roundoff = module.unit_roundoff;
  info.settings = CommonSettings(precision);
  for (Setting& setting : dispatch ? WorldDispatchSettings() : ClosestPointsSettings()) {
    info.settings.push_back(std::move(setting));
  }
  for (int i = 0; i < kShapeKinds; ++i) {
    for (int j = 0; j < kShapeKinds; ++j) {
      const auto a = static_cast<ShapeKind>(i);
      const auto b = static_cast<ShapeKind>(j);
      info.capabilities[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
          dispatch ? WorldDispatchCapability(a, b, precision)
                   : ClosestPointsCapability(a, b, precision);
    }
  }
  return info;
}

}  // namespace touchstone
