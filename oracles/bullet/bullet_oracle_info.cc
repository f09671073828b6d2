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
      {"world: solver", "btSequentialImpulseConstraintSolver", "Bullet's default."},
      {"world: restitution", "min(e_A, e_B)",
       "gCalculateCombinedRestitutionCallback; Bullet's default is the product."},
      {"world: friction", "sqrt(mu_A mu_B)",
       "gCalculateCombinedFrictionCallback; Bullet's default is the product."},
      {"world: damping", "0", "Bullet's default."},
      {"world: inertia", "as stated, else that of the uniform solid",
       "Passed to Bullet, which does not compute it."},
      {"world: impulses", "those of the manifold points, normal and both lateral",
       "Applied midway between the positions on A and on B."},
  };
}

std::vector<WorldParameter> ParametersOf(BulletPrecision precision) {
  const bool is_float = precision == BulletPrecision::kFloat;
  std::vector<WorldParameter> parameters(kBulletParameters);
  parameters[kBulletIterations] = {
      .name = "iterations",
      .here = 1000,
      .shipped = 10,
      .least = 1,
      .most = 1'000'000,
      .whole = true,
      .what = "most iterations of the solver; m_numIterations",
      .why = "Bullet's default leaves a residual that would hide its contact law."};
  parameters[kBulletResidual] = {
      .name = "residual",
      .here = 4 * (is_float ? 0x1p-23 : 0x1p-52),
      .shipped = 0,
      .least = 0,
      .most = 1,
      .whole = false,
      .what =
          "change of velocity in m/s at which the solver stops, the root of "
          "m_leastSquaresResidualThreshold",
      .why = "4 roundings of 1 m/s: more iterations would only change rounding errors."};
  parameters[kBulletErp] = {
      .name = "erp",
      .here = 0,
      .shipped = 0.2,
      .least = 0,
      .most = 1,
      .whole = false,
      .what = "fraction of an overlap that a step removes; m_erp and m_erp2",
      .why =
          "Overlap is not pushed out, which would add energy: bodies rest at the "
          "depth at which they were found."};
  parameters[kBulletSplitImpulse] = {
      .name = "split_impulse",
      .here = 0,
      .shipped = 1,
      .least = 0,
      .most = 1,
      .whole = true,
      .what =
          "whether overlap beyond 0.04 m is removed without a change of velocity; "
          "m_splitImpulse",
      .why = "Overlap is not pushed out."};
  parameters[kBulletFrictionDirections] = {
      .name = "friction_directions",
      .here = 2,
      .shipped = 1,
      .least = 1,
      .most = 2,
      .whole = true,
      .what =
          "directions of friction, the first along the slip; "
          "SOLVER_USE_2_FRICTION_DIRECTIONS",
      .why = "Bullet's default leaves the other direction without friction."};
  parameters[kBulletProcessingThreshold] = {
      .name = "processing_threshold",
      .here = 0,
      .shipped = 1e18,  // BT_LARGE_FLOAT of a build in single precision.
      .least = 0,
      .most = 1e18,
      .whole = false,
      .what =
          "separation in m up to which a contact is solved; "
          "setContactProcessingThreshold",
      .why =
          "Contacts that are still apart are not solved early: they would lose their "
          "restitution."};
  parameters[kBulletRestitutionThreshold] = {
      .name = "restitution_threshold",
      .here = 0,
      .shipped = 0.2,
      .least = 0,
      .most = 1e3,
      .whole = false,
      .what =
          "approach in m/s below which nothing bounces; "
          "m_restitutionVelocityThreshold",
      .why = "Bullet's default ends a bounce early."};
  parameters[kBulletMargin] = {
      .name = "margin",
      .here = 0,
      .shipped = 0.04,  // CONVEX_DISTANCE_MARGIN.
      .least = 0,
      .most = 1e3,
      .whole = false,
      .what =
          "margin in m by which hulls and cones are enlarged, and boxes and cylinders "
          "rounded within their size, at most a tenth of it; setMargin",
      .why = "Bullet's default lets a hull float 4 cm above what it rests on."};
  parameters[kBulletSleeping] = {
      .name = "sleeping",
      .here = 0,
      .shipped = 1,
      .least = 0,
      .most = 1,
      .whole = true,
      .what =
          "whether bodies slower than 0.8 m/s and 1 rad/s for 2 s are stopped; "
          "DISABLE_DEACTIVATION if not",
      .why = "A body that falls asleep loses its momentum."};
  const auto like_bullet = [&](BulletParameter index, std::string name, double shipped,
                               double most, bool whole, std::string what) {
    parameters[index] = {.name = std::move(name),
                         .here = shipped,
                         .shipped = shipped,
                         .least = 0,
                         .most = most,
                         .whole = whole,
                         .what = std::move(what),
                         .why = ""};
  };
  like_bullet(
      kBulletContinuous, "ccd_threshold", 0, 1e3, false,
      "motion in m in a step beyond which a body is stopped at its first contact, "
      "0: never; setCcdMotionThreshold");
  like_bullet(kBulletSweptRadius, "ccd_radius", 0, 1e3, false,
              "radius in m of the ball that is swept for it; setCcdSweptSphereRadius");
  like_bullet(kBulletGyroscopic, "gyroscopic", 3, 3, true,
              "gyroscopic term: 0 none, 1 explicit, 2 implicit in the world frame, 3 "
              "implicit in the body frame; BT_ENABLE_GYROSCOPIC_FORCE_…");
  like_bullet(
      kBulletRollingFriction, "rolling_friction", 0, 1e3, false,
      "lever in m, times the friction of the other body, of the torque that brakes "
      "rolling; setRollingFriction");
  like_bullet(kBulletSpinningFriction, "spinning_friction", 0, 1e3, false,
              "the same for spin about the normal, where rolling_friction is not 0; "
              "setSpinningFriction");
  return parameters;
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
    info.parameters = ParametersOf(precision);
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
