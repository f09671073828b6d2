#include "oracles/bullet/bullet_oracle_info.h"

#include <utility>

namespace touchstone {
namespace {

/** The convergence tolerances of Bullet's iterations, from its own constants. */
struct Convergence {
  double epa;  ///< EPA_ACCURACY in btGjkEpa2.cpp. [m]
  double gjk;  ///< REL_ERROR2 in btGjkPairDetector.cpp: a fraction of the distance.
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

/* The capability of the algorithm that
 btDefaultCollisionConfiguration::getCollisionAlgorithmCreateFunc() chooses, with the
 special cases inside btConvexConvexAlgorithm::processCollision(). */
Capability WorldDispatchCapability(ShapeKind a, ShapeKind b, BulletPrecision precision) {
  const bool a_plane = a == ShapeKind::kHalfSpace;
  const bool b_plane = b == ShapeKind::kHalfSpace;
  if (a_plane && b_plane) return Unsupported("two planes have no contact algorithm");
  Capability capability = GjkEpa(ConvergenceOf(precision));
  const bool plane = a_plane || b_plane;  // btConvexPlaneCollisionAlgorithm
  const bool boxes = a == ShapeKind::kBox && b == ShapeKind::kBox;
  // All others find one point per call. A stepped world collects these points into a
  // manifold over several steps.
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
  capability.penetrating_witnesses = true;
  capability.documented_relative_error = convergence.gjk;
  capability.documented_by += "; REL_ERROR2, btGjkPairDetector.cpp";
  return capability;
}

std::vector<Setting> CommonSettings(BulletPrecision precision) {
  std::vector<Setting> settings = {
      {"scalar", precision == BulletPrecision::kDouble ? "double" : "float",
       "Debian ships both builds. Sizes and poses are rounded to this type."},
      {"normal", "B->A, negated", "The project's normals point from A to B."},
      {"separation", "Bullet's signed distance",
       "Negative penetrating, as in the project."},
      {"pose", "the rotation matrix itself", "A quaternion would round it once more."},
      {"box", "half extents, margin 0",
       "A margin rounds edges and corners in GJK; margin 0 keeps the size."},
      {"cylinder", "btCylinderShapeZ, half extents, margin 0", "Same as for the box."},
      {"cone", "btConeShapeZ, full height, margin 0",
       "Bullet's cone is also centred at half its height; a margin would enlarge it."},
      {"convex hull", "margin 0", "A margin would enlarge it by that amount."},
      {"sphere, capsule", "margin = radius",
       "Bullet represents their radius as the margin."},
  };
  return settings;
}

std::vector<Setting> WorldDispatchSettings() {
  return {
      {"algorithm", "BT_CONTACT_POINT_ALGORITHMS, run once on an empty manifold",
       "The algorithm of a stepped world; for box-box it is btBoxBoxDetector."},
      {"contact position", "midway between the positions on A and on B",
       "The project's convention; Bullet returns both positions."},
      {"contacts apart", "not touching; the least distance is passed on",
       "A manifold also holds points that are apart, up to "
       "the contact breaking threshold."},
      {"contact breaking threshold", "0.02 times the shape's size, Bullet's default",
       "Points closer to each other than this are merged into one contact."},
      {"half-space", "btStaticPlaneShape, normal z", "One contact: the deepest vertex."},
      {"contacts per pair", "box-box up to 4, others 1",
       "Bullet adds more over the steps of a world; an oracle keeps no state."},
  };
}

std::vector<Setting> ClosestPointsSettings() {
  return {
      {"algorithm", "btGjkPairDetector with btGjkEpaPenetrationDepthSolver",
       "Bullet's closest points, without its contact manifold."},
      {"witnesses", "point on B as given, point on A = point on B + distance * normal",
       "The same formula as in btManifoldResult."},
  };
}

std::vector<Setting> WorldSettings() {
  return {
      {"world: step", "btDiscreteDynamicsWorld::stepSimulation(dt, 0)",
       "One step of that length; by default Bullet divides it into steps of 1/60 s."},
      {"world: integrator", "semi-implicit Euler, rotation by the exponential map",
       "Bullet has no other."},
      {"world: solver", "btSequentialImpulseConstraintSolver, up to 1000 iterations",
       "Bullet's default of 10 leaves a residual that would hide its contact law. The "
       "solver stops when no velocity changes by 4 roundings of 1 m/s."},
      {"world: restitution", "min(e_A, e_B)",
       "gCalculateCombinedRestitutionCallback; Bullet's default is the product."},
      {"world: restitution velocity threshold", "0",
       "Bullet's default of 0.2 m/s ends a bounce early."},
      {"world: friction", "sqrt(mu_A mu_B)",
       "gCalculateCombinedFrictionCallback; Bullet's default is the product."},
      {"world: friction directions", "2, the first along the slip",
       "SOLVER_USE_2_FRICTION_DIRECTIONS: Coulomb's cone. Bullet's default of 1 leaves "
       "the other direction without friction."},
      {"world: contact processing threshold", "0",
       "Contacts that are still apart are not solved early: "
       "they would lose their restitution."},
      {"world: error reduction", "erp = erp2 = 0, split impulse off",
       "Overlap is not pushed out, which would add energy: bodies rest at the depth at "
       "which they were found."},
      {"world: gyroscopic term", "implicit, body frame", "Bullet's default."},
      {"world: damping", "0", "Bullet's default."},
      {"world: sleeping", "off", "DISABLE_DEACTIVATION."},
      {"world: inertia", "as stated, else that of the uniform solid",
       "Passed to Bullet, which does not compute it."},
      {"world: impulses", "those of the manifold points, normal and both lateral",
       "Applied midway between the positions on A and on B."},
  };
}

/* Returns why Bullet does not simulate `feature`; empty if it does. */
std::string WhyNot(WorldFeature feature) {
  switch (feature) {
    case WorldFeature::kParticle:
    case WorldFeature::kCloth:
      return "Bullet has no point masses; its soft bodies are another engine";
    case WorldFeature::kSpring:
      return "Bullet has springs along the axes of a body but none between two points";
    case WorldFeature::kDistanceJoint:
      return "Bullet has no joint that keeps two points at a distance";
    default:
      return "";
  }
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
  // btGjkPairDetector moves both bodies by the middle of their positions,
  // btBoxBoxDetector and the closed forms use the difference of the positions.
  info.subtracts_first = true;
  info.settings = CommonSettings(precision);
  for (Setting& setting : dispatch ? WorldDispatchSettings() : ClosestPointsSettings()) {
    info.settings.push_back(std::move(setting));
  }
  info.simulates = dispatch;
  if (info.simulates) {
    for (Setting& setting : WorldSettings()) info.settings.push_back(std::move(setting));
    for (int i = 0; i < kWorldFeatures; ++i) {
      const auto feature = static_cast<WorldFeature>(i);
      const std::string reason = WhyNot(feature);
      info.world_capabilities[static_cast<std::size_t>(i)] = {reason.empty(), reason};
    }
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
