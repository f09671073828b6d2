#include "reports/worlds/study/world_variants.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace touchstone {
namespace {

/** The angle of the turned variant: no simple fraction of a full turn or a right angle.
 [rad] */
constexpr double kTurn = 0.7390851332151607;

/** The offset of the moved variant: not exact in binary, and about as large as the
 worlds. [m] */
const Eigen::Vector3d kOffset(3.7, -2.3, 5.9);

/** Applies x → S x + offset to everything in a world. The frame of a mirrored body stays
 right-handed: its rotation becomes S R M, with M the mirror of the body's first axis. M
 leaves every symmetric shape and every principal inertia unchanged. */
class Mover {
 public:
  Mover(const Eigen::Matrix3d& S, const Eigen::Vector3d& offset)
      : S_(S), offset_(offset), handed_(S.determinant()) {
    if (handed_ < 0) body_(0, 0) = -1;
  }

  World operator()(World world) const {
    for (RigidBody& body : world.bodies) {
      const Eigen::Matrix3d R = S_ * body.placed.X_WB.R_WB * body_;
      body.placed.X_WB = Pose::FromQuaternion(Place(body.placed.X_WB.p_WB),
                                              Eigen::Quaterniond(R).normalized());
      body.v_WB = S_ * body.v_WB;
      body.w_WB = handed_ * (S_ * body.w_WB);  // A spin is an axial vector.
      body.force_W = S_ * body.force_W;
    }
    for (Particle& particle : world.particles) {
      particle.p_W = Place(particle.p_W);
      particle.v_W = S_ * particle.v_W;
    }
    for (Spring& spring : world.springs) MoveAnchors(spring.A, spring.B);
    for (DistanceJoint& joint : world.joints) MoveAnchors(joint.A, joint.B);
    for (Cloth& cloth : world.cloths) cloth.centre = Place(cloth.centre);
    for (Push& push : world.pushes) {
      push.p_BoP = body_ * push.p_BoP;
      push.J_W = S_ * push.J_W;
    }
    world.gravity_W = S_ * world.gravity_W;
    return world;
  }

 private:
  Eigen::Vector3d Place(const Eigen::Vector3d& p_W) const { return S_ * p_W + offset_; }

  void MoveAnchors(Anchor& A, Anchor& B) const {
    for (Anchor* anchor : {&A, &B}) {
      if (anchor->on == AnchorKind::kWorld) anchor->point = Place(anchor->point);
      if (anchor->on == AnchorKind::kBody) anchor->point = body_ * anchor->point;
    }
  }

  Eigen::Matrix3d S_;
  Eigen::Vector3d offset_;
  double handed_;
  Eigen::Matrix3d body_ = Eigen::Matrix3d::Identity();
};

std::vector<int> Identity(const World& world) {
  std::vector<int> order(world.bodies.size());
  std::iota(order.begin(), order.end(), 0);
  return order;
}

WorldVariant Moved(MeasureKind measure, const World& world, const Eigen::Matrix3d& S,
                   const Eigen::Vector3d& offset) {
  return {measure, Mover(S, offset)(world), S, offset, Identity(world)};
}

bool HasHull(const World& world) {
  return std::any_of(world.bodies.begin(), world.bodies.end(), [](const RigidBody& body) {
    return KindOf(body.placed.shape) == ShapeKind::kConvexHull;
  });
}

Eigen::Vector3d Up(const World& world) {
  const double g = world.gravity_W.norm();
  return g > 0 ? Eigen::Vector3d(-world.gravity_W / g) : Eigen::Vector3d::UnitY();
}

WorldVariant Reordered(const World& world) {
  WorldVariant variant{.measure = MeasureKind::kPermutation, .world = world};
  variant.order = Identity(world);
  std::reverse(variant.order.begin(), variant.order.end());
  const int last = static_cast<int>(world.bodies.size()) - 1;
  std::reverse(variant.world.bodies.begin(), variant.world.bodies.end());
  const auto rename = [&](Anchor& anchor) {
    if (anchor.on == AnchorKind::kBody) anchor.index = last - anchor.index;
  };
  for (Spring& spring : variant.world.springs) rename(spring.A), rename(spring.B);
  for (DistanceJoint& joint : variant.world.joints) rename(joint.A), rename(joint.B);
  for (Push& push : variant.world.pushes) push.body = last - push.body;
  return variant;
}

WorldVariant Heavier(const World& world) {
  constexpr double kFactor = 3;
  WorldVariant variant{.measure = MeasureKind::kMassScaling, .world = world};
  variant.order = Identity(world);
  for (RigidBody& body : variant.world.bodies) {
    body.mass *= kFactor;
    if (body.inertia) *body.inertia *= kFactor;
    body.force_W *= kFactor;
  }
  for (Particle& particle : variant.world.particles) particle.mass *= kFactor;
  for (Spring& spring : variant.world.springs) {
    spring.stiffness *= kFactor;
    spring.damping *= kFactor;
  }
  for (Cloth& cloth : variant.world.cloths) {
    cloth.node_mass *= kFactor;
    for (ClothSprings* springs : {&cloth.structural, &cloth.shear, &cloth.bend}) {
      springs->stiffness *= kFactor;
      springs->damping *= kFactor;
    }
  }
  for (Push& push : variant.world.pushes) push.J_W *= kFactor;
  return variant;
}

}  // namespace

std::vector<WorldVariant> VariantsOf(const World& world) {
  std::vector<WorldVariant> variants;
  const Eigen::Vector3d up = Up(world);
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  if (world.cloths.empty()) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(kTurn, up).toRotationMatrix();
    variants.push_back(Moved(MeasureKind::kHeading, world, turn, none));
  }
  variants.push_back(
      Moved(MeasureKind::kTranslation, world, Eigen::Matrix3d::Identity(), kOffset));
  if (world.cloths.empty() && !HasHull(world)) {
    const Eigen::Vector3d n = up.unitOrthogonal();
    const Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity() - 2 * n * n.transpose();
    variants.push_back(Moved(MeasureKind::kMirror, world, mirror, none));
  }
  if (world.bodies.size() > 1) variants.push_back(Reordered(world));
  variants.push_back(Heavier(world));
  return variants;
}

std::vector<Claim> ClaimsOf(const WorldVariant& variant, std::vector<Claim> claims) {
  for (Claim& claim : claims) {
    const auto of = [&](const char* axis) {
      const auto found = claim.numbers.find(axis);
      return found == claim.numbers.end() ? 0.0 : found->second;
    };
    const Eigen::Vector3d direction(of("x"), of("y"), of("z"));
    if (direction.isZero(0)) continue;
    const Eigen::Vector3d turned = variant.S * direction;
    claim.numbers["x"] = turned.x();
    claim.numbers["y"] = turned.y();
    claim.numbers["z"] = turned.z();
  }
  return claims;
}

Eigen::Vector3d SeenInWorld(const WorldVariant& variant, const Eigen::Vector3d& p_V) {
  return variant.S.transpose() * (p_V - variant.offset);
}

Trajectory SeenInWorld(const WorldVariant& variant, Trajectory trajectory) {
  const Eigen::Matrix3d S_inverse = variant.S.transpose();
  const double handed = variant.S.determinant();
  Eigen::Matrix3d body_mirror = Eigen::Matrix3d::Identity();
  if (handed < 0) body_mirror(0, 0) = -1;
  const auto back = [&](Eigen::Vector3d& p, Eigen::Vector3d& v) {
    p = SeenInWorld(variant, p);
    v = S_inverse * v;
  };
  for (WorldState& state : trajectory.samples) {
    std::vector<BodyState> bodies(state.bodies.size());
    for (std::size_t i = 0; i < state.bodies.size(); ++i) {
      BodyState body = state.bodies[i];
      back(body.p_WB, body.v_WB);
      body.w_WB = handed * (S_inverse * body.w_WB);
      const Eigen::Matrix3d R =
          S_inverse * body.q_WB.normalized().toRotationMatrix() * body_mirror;
      body.q_WB = Eigen::Quaterniond(R);
      bodies[static_cast<std::size_t>(variant.order[i])] = body;
    }
    state.bodies = std::move(bodies);
    for (PointState& point : state.particles) back(point.p_W, point.v_W);
    for (PointState& point : state.nodes) back(point.p_W, point.v_W);
  }
  return trajectory;
}

}  // namespace touchstone
