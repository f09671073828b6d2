// The contract of an oracle that simulates worlds, in addition to that of contact
// queries. It states exactly what it does not support and supports the rest. Its free
// flight and its oblique bounce agree with closed forms.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "oracles/oracle_registry.h"
#include "scenarios/worlds/validate_world.h"

namespace touchstone {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using enum WorldFeature;

const OracleRegistry& Registry() {
  static const OracleRegistry registry = OracleRegistry::BuiltIn();
  return registry;
}

/** An oracle that simulates worlds. An oracle without a row does not. */
struct Simulator {
  std::string_view oracle;
  std::vector<WorldFeature> cannot;  ///< All features that it does not support.
  /** The fraction of an impulse by which the engine falls short by design. */
  double softness = 0;
  /** Whether its contact law is the convex relaxation of Coulomb's law: a sliding body
   also lifts off, at μ times its slip velocity (Anitescu 2006). */
  bool is_convex = false;
  /** Whether it solves contacts in each stage of a step. An impact then takes several
   steps, and a body that lifts off leaves before the impact is complete. It is tested
   without friction, so that nothing lifts off. */
  bool is_staged = false;
};

/** Those of the shapes beyond spheres, boxes and static half-spaces. */
const std::vector<WorldFeature> kOtherShapes = {
    kCapsule,       kCylinder,       kCone,       kConvexHull,
    kStaticCapsule, kStaticCylinder, kStaticCone, kStaticConvexHull};

std::vector<WorldFeature> OtherShapesAnd(std::vector<WorldFeature> more) {
  more.insert(more.end(), kOtherShapes.begin(), kOtherShapes.end());
  return more;
}

const std::vector<Simulator> kSimulators = {
    {"bullet", {kParticle, kSpring, kDistanceJoint, kCloth}},
    {"bullet_float", {kParticle, kSpring, kDistanceJoint, kCloth}},
    {"cookbook", kOtherShapes},
    {"cookbook/sleeping", kOtherShapes},
    // The softness is its constraint force mixing, relative to the diagonal of its
    // matrix.
    {"dart",
     OtherShapesAnd({kStaticHalfSpace, kParticle, kSpring, kDistanceJoint, kCloth}),
     1e-9},
    // The softness follows from mjMAXIMP: a contact reaches at most 0.9999 of its target.
    {"mujoco", {kCone, kStaticCone, kRestitution, kParticle, kCloth}, 1 - 0.9999, true},
    {"mujoco/rk4",
     {kCone, kStaticCone, kRestitution, kParticle, kCloth},
     1 - 0.9999,
     true,
     true},
    // Its constraints yield by CFM = 1e-12 (m/s)/N, which is m CFM/h = 1.3e-9 of an
    // impulse.
    {"ode", {kCone, kStaticCone, kParticle, kCloth}, 1.3e-9},
    {"ode/quick", {kCone, kStaticCone, kParticle, kCloth}, 1.3e-9},
    {"printed:none", OtherShapesAnd({kStaticHalfSpace})},
};

const Simulator* RowOf(std::string_view oracle) {
  const auto row = std::find_if(kSimulators.begin(), kSimulators.end(),
                                [&](const Simulator& r) { return r.oracle == oracle; });
  return row == kSimulators.end() ? nullptr : &*row;
}

RigidBody Ball(const Vector3d& p_W) {
  RigidBody ball;
  ball.name = "ball";
  ball.mass = 1.3;
  ball.placed = {Sphere{0.3}, Pose::FromQuaternion(p_W, {1, 0, 0, 0})};
  ball.restitution = 0;
  return ball;
}

/* Returns a static body at `p_W`, which must place its top at z = 0. */
RigidBody Slab(const Shape& shape, const Vector3d& p_W) {
  RigidBody slab;
  slab.name = "slab";
  slab.mass = 0;
  slab.placed = {shape, Pose::FromQuaternion(p_W, {1, 0, 0, 0})};
  slab.restitution = 0;
  return slab;
}

RigidBody SlabOfBox() {
  return Slab(Box{{20, 20, 0.7}}, {0, 0, -0.7});
}

ConvexHull Octahedron(double r) {
  return {{{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}}};
}

/* Returns a short world that needs `feature` and, if possible, no other feature except
 spheres. */
World WorldWith(WorldFeature feature) {
  World world;
  world.gravity_W = {0, 0, -9.81};
  world.steps = 12;
  world.bodies = {Ball({0, 0, 0.31})};
  RigidBody& ball = world.bodies[0];
  const Anchor on_ball{AnchorKind::kBody, 0, Vector3d::Zero()};
  const Anchor in_world{AnchorKind::kWorld, -1, Vector3d(0.2, 0.1, 1.1)};
  switch (feature) {
    case kSphere:
      break;
    case kBox:
      ball.placed.shape = Box{{0.3, 0.2, 0.1}};
      break;
    case kCapsule:
      ball.placed.shape = Capsule{0.3, 0.2};
      break;
    case kCylinder:
      ball.placed.shape = Cylinder{0.3, 0.2};
      break;
    case kCone:
      ball.placed.shape = Cone{0.3, 0.2};
      ball.inertia = Vector3d(0.1, 0.1, 0.05);
      break;
    case kConvexHull:
      ball.placed.shape = Octahedron(0.3);
      break;
    case kStaticSphere:
      world.bodies.push_back(Slab(Sphere{0.4}, {0, 0, -0.4}));
      break;
    case kStaticBox:
      world.bodies.push_back(SlabOfBox());
      break;
    case kStaticHalfSpace:
      world.bodies.push_back(Slab(HalfSpace{}, Vector3d::Zero()));
      break;
    case kStaticCapsule:
      world.bodies.push_back(Slab(Capsule{0.4, 0.2}, {0, 0, -0.6}));
      break;
    case kStaticCylinder:
      world.bodies.push_back(Slab(Cylinder{0.4, 0.2}, {0, 0, -0.2}));
      break;
    case kStaticCone:
      world.bodies.push_back(Slab(Cone{0.4, 0.2}, {0, 0, -0.2}));
      break;
    case kStaticConvexHull:
      world.bodies.push_back(Slab(Octahedron(0.4), {0, 0, -0.4}));
      break;
    case kStatedInertia:
      ball.inertia = Vector3d(0.1, 0.09, 0.05);
      break;
    case kRestitution:
      ball.restitution = 0.5;
      world.bodies.push_back(SlabOfBox());
      world.bodies.back().restitution = 0.7;
      break;
    case kFriction:
      world.bodies.push_back(SlabOfBox());
      break;
    case kMovingBodies:
      world.bodies.push_back(Ball({1, 0, 0.31}));
      world.bodies.back().name = "other";
      break;
    case kUnequalFriction:
      world.bodies.push_back(SlabOfBox());
      world.bodies.back().friction = 0.3;
      break;
    case kForce:
      ball.force_W = {0.1, 0.2, 0.3};
      break;
    case kParticle:
      world.particles.push_back({"p", {1, 1, 1}});
      break;
    case kSpring:
      world.springs.push_back({on_ball, in_world, 100, 1, 0.5});
      break;
    case kDistanceJoint:
      world.joints.push_back(
          {on_ball, in_world, (in_world.point - ball.placed.X_WB.p_WB).norm()});
      break;
    case kCloth:
      world.cloths.emplace_back().name = "cloth";
      break;
    case kPush:
      world.pushes.push_back({0, 0, {0, 0, 0.3}, {0.1, 0.2, 0.3}});
      break;
  }
  return world;
}

class WorldConformance : public testing::TestWithParam<std::string> {
 protected:
  const Oracle& oracle() const { return *Registry().Find(GetParam()); }
  const Simulator& row() const { return *RowOf(GetParam()); }

  bool Supports(WorldFeature feature) const {
    return oracle().info().For(feature).supported;
  }

  /** Returns the rounding error of velocities of a few metres per second after all steps
   of `world`. [m/s] */
  double Rounding(const World& world) const {
    return 64 * world.steps * oracle().info().unit_roundoff;
  }
};

TEST_P(WorldConformance, StatesExactlyWhatItDoesNotSupportAndSupportsTheRest) {
  for (int i = 0; i < kWorldFeatures; ++i) {
    const auto feature = static_cast<WorldFeature>(i);
    SCOPED_TRACE(NameOf(feature));
    const WorldCapability& capability = oracle().info().For(feature);
    EXPECT_EQ(capability.supported, std::find(row().cannot.begin(), row().cannot.end(),
                                              feature) == row().cannot.end());
    EXPECT_EQ(capability.supported, capability.reason.empty());
    const World world = WorldWith(feature);
    ASSERT_TRUE(FaultsOf(world).empty());
    const std::vector<WorldFeature> asked = FeaturesOf(world);
    ASSERT_NE(std::find(asked.begin(), asked.end(), feature), asked.end());
    const Trajectory trajectory = oracle().Simulate(world);
    EXPECT_EQ(trajectory.status,
              capability.supported ? AnswerStatus::kAnswered : AnswerStatus::kUnsupported)
        << trajectory.reason;
    EXPECT_EQ(trajectory.reason, capability.reason);
  }
}

TEST_P(WorldConformance, FreeFlightAndSpinAgreeWithTheirClosedForms) {
  World world;
  world.gravity_W = {0.3, -0.7, -9.81};
  world.dt = 1.0 / 300;
  world.steps = 450;
  world.sample_every = 45;
  world.bodies = {Ball({0.3, -0.2, 1.7})};
  RigidBody& ball = world.bodies[0];
  ball.v_WB = {1.1, 0.4, 3.3};
  ball.w_WB = {0.3, -1.2, 0.7};
  const Trajectory trajectory = oracle().Simulate(world);
  ASSERT_EQ(trajectory.samples.size(), 11u) << trajectory.reason;
  for (std::size_t i = 0; i < trajectory.samples.size(); ++i) {
    const double t = trajectory.times[i];
    const BodyState& state = trajectory.samples[i].bodies[0];
    const double rounding = Rounding(world);
    EXPECT_LE((state.v_WB - (ball.v_WB + t * world.gravity_W)).norm(), 8 * rounding);
    // The velocity of a first-order method is off by half a step of gravity, that of
    // others by less.
    const Vector3d p_W =
        ball.placed.X_WB.p_WB + t * ball.v_WB + t * t / 2 * world.gravity_W;
    EXPECT_LE((state.p_WB - p_W).norm(),
              world.gravity_W.norm() * world.dt * t / 2 + 8 * rounding);
    EXPECT_LE((state.w_WB - ball.w_WB).norm(), rounding);
    // An Euler step of a quaternion rotates by the half angle atan(wh/2) instead of wh/2.
    const double w = ball.w_WB.norm();
    const Quaterniond q(Eigen::AngleAxisd(w * t, ball.w_WB / w));
    EXPECT_LE(state.q_WB.angularDistance(q),
              w * w * w * world.dt * world.dt * t / 12 * 1.01 + rounding);
  }
}

/* Expects the closed form of a ball that hits a slab obliquely. There is no gravity, so
 that only the one impact happens. The slip is along an axis, where all kinds of friction
 cones agree. Coulomb's law with μ < 2/7 |u| / ((1 + e) |v_n|), where u is the slip before
 the impact, so that the ball slides throughout. With J, the normal impulse divided by the
 mass:

     J = (1 + e) |v_n|,  v_n' = J − |v_n|,  v_t' = v_t − μ J,  ω' = 5/2 μ J / R

 The convex law, for e = 0, has v_n' = μ u' = μ (u − 7/2 μ J) in place of v_n' = 0. */
void ExpectObliqueBounce(const Oracle& oracle, const Simulator& row, double e) {
  const double mu = row.is_staged ? 0 : 0.2;
  constexpr double kRadius = 0.3;
  const double vt = 5 * std::sin(std::numbers::pi / 3);
  const double vn = 5 * std::cos(std::numbers::pi / 3);
  World world;
  world.gravity_W.setZero();
  world.dt = 1.0 / 1000;
  world.steps = 100;
  world.bodies = {Ball({0, 0, kRadius + 0.1}), SlabOfBox()};
  RigidBody& ball = world.bodies[0];
  RigidBody& slab = world.bodies[1];
  ball.v_WB = {vt, 0, -vn};
  ball.restitution = e;
  slab.restitution = e > 0 ? 1 : 0;  // min(e, 1)
  ball.friction = slab.friction = mu;
  if (oracle.info().For(kUnequalFriction).supported) {
    ball.friction = mu / 2;  // sqrt(mu/2 2mu) = mu
    slab.friction = mu * 2;
  }
  const Trajectory trajectory = oracle.Simulate(world);
  ASSERT_EQ(trajectory.status, AnswerStatus::kAnswered) << trajectory.reason;
  const double J = row.is_convex ? (vn + mu * vt) / (1 + 3.5 * mu * mu) : (1 + e) * vn;
  const BodyState& after = trajectory.samples.back().bodies[0];
  const double allowed = 2 * row.softness * J + 64 * 16 * oracle.info().unit_roundoff * 5;
  EXPECT_LE((after.v_WB - Vector3d(vt - mu * J, 0, J - vn)).norm(), allowed);
  // Friction acts at most |v_n| h inside the slab, so the lever arm is that much shorter
  // than R.
  const Vector3d w_W(0, 2.5 * mu * J / kRadius, 0);
  EXPECT_LE((after.w_WB - w_W).norm(),
            w_W.norm() * vn * world.dt / kRadius + 2.5 / kRadius * allowed);
}

TEST_P(WorldConformance, ObliqueBounceAgreesWithCoulombsLaw) {
  if (Supports(kRestitution)) {
    ExpectObliqueBounce(oracle(), row(), 0.8);
  } else {
    EXPECT_EQ(oracle().Simulate(WorldWith(kRestitution)).status,
              AnswerStatus::kUnsupported);
  }
}

TEST_P(WorldConformance, ObliqueImpactWithoutRestitutionAgreesWithTheContactLaw) {
  ExpectObliqueBounce(oracle(), row(), 0);
}

std::vector<std::string> NamesOfSimulators() {
  std::vector<std::string> names;
  for (const Simulator& row : kSimulators) {
    if (Registry().Find(row.oracle) != nullptr) names.emplace_back(row.oracle);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(, WorldConformance, testing::ValuesIn(NamesOfSimulators()),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace_if(
                               name.begin(), name.end(),
                               [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
                           return name;
                         });

TEST(WorldConformanceTable, HasARowForEveryOracleThatSimulates) {
  for (const Oracle* oracle : Registry().All()) {
    const OracleInfo& info = oracle->info();
    if (info.name == "printed") continue;  // Its errata violate the contract on purpose.
    EXPECT_EQ(info.simulates, RowOf(info.name) != nullptr) << info.name;
  }
}

}  // namespace
}  // namespace touchstone
