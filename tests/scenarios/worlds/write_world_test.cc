#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "scenarios/scenario_file.h"
#include "scenarios/worlds/magnitudes.h"
#include "scenarios/worlds/validate_world.h"
#include "tests/scenarios/any_parts.h"
#include "tests/scenarios/same_bits.h"

namespace touchstone {
namespace {

bool Maybe() {
  return *rc::gen::arbitrary<bool>();
}

double AnyShare() {
  return *rc::gen::inRange(0, 998) / 997.0;
}

/** Returns any number that is at most `most` in magnitude. */
double AnyUpTo(double most) {
  const double value = AnyNumber();
  return std::abs(value) <= most ? value : std::copysign(most / 3, value);
}

double AnyNotNegative() {
  return std::abs(AnyUpTo(kMostMagnitude));
}

double AnySize() {
  const double value = std::abs(AnyNumber());
  return value >= kLeastMagnitude && value <= kMostMagnitude ? value : 1.0 / 3;
}

/** Returns a coordinate, velocity or acceleration vector. Free fall with them stays
 within kMostReached for the longest world here. */
Eigen::Vector3d AnyVector() {
  constexpr double kMost = 1e4;
  return {AnyUpTo(kMost), AnyUpTo(kMost), AnyUpTo(kMost)};
}

/** Returns a shape of any kind with sizes that a world may have. */
Shape AnySizedShape() {
  const Shape shape = AnyShape(false);
  switch (KindOf(shape)) {
    case ShapeKind::kSphere:
      return Sphere{AnySize()};
    case ShapeKind::kBox:
      return Box{{AnySize(), AnySize(), AnySize()}};
    case ShapeKind::kCapsule:
      return Capsule{AnySize(), AnySize()};
    case ShapeKind::kCylinder:
      return Cylinder{AnySize(), AnySize()};
    case ShapeKind::kCone:
      return Cone{AnySize(), AnySize()};
    case ShapeKind::kConvexHull:
      return ConvexHull{{{0.1, 0.2, AnySize()}, {1, 0, 0}}};
    case ShapeKind::kHalfSpace:
      return shape;
  }
  return shape;
}

RigidBody AnyBody(const std::string& name) {
  RigidBody body;
  body.name = name;
  body.placed = {AnySizedShape(), AnyPose()};
  const auto is_place = [](double x) { return x == 0 || std::abs(x) >= kShortest; };
  for (double& x : body.placed.X_WB.p_WB = AnyVector()) x = is_place(x) ? x : -0.0;
  body.mass = KindOf(body.placed.shape) == ShapeKind::kHalfSpace || Maybe() ? 0 : 2.5;
  if (body.mass != 0) {
    body.v_WB = AnyVector();
    body.w_WB = Maybe() ? AnyVector() : Eigen::Vector3d(0, -0.0, 0);
    body.force_W = AnyVector();
  }
  if (body.mass != 0 || Maybe()) body.inertia = Eigen::Vector3d(0.1, 0.2, 0.1 + 0.2);
  body.restitution = AnyShare();
  body.friction = AnyNotNegative();
  body.collides = Maybe();
  return body;
}

Particle AnyParticle(const std::string& name) {
  Particle particle;
  particle.name = name;
  particle.p_W = AnyVector();
  particle.mass = Maybe() ? AnySize() : 0;
  if (particle.mass > 0) particle.v_W = AnyVector();
  particle.damping = AnyNotNegative();
  particle.bounce = AnyShare();
  return particle;
}

ClothSprings AnyClothSprings() {
  return {AnyNotNegative(), AnyNotNegative()};
}

Cloth AnyCloth(const std::string& name) {
  Cloth cloth;
  cloth.name = name;
  cloth.n = *rc::gen::inRange(3, 9);
  cloth.spacing = AnySize();
  cloth.centre = AnyVector();
  cloth.node_mass = AnySize();
  cloth.damping = AnyNotNegative();
  cloth.bounce = AnyShare();
  cloth.structural = AnyClothSprings();
  cloth.shear = AnyClothSprings();
  cloth.bend = AnyClothSprings();
  if (Maybe()) cloth.pinned = {{0, cloth.n - 1}, {0, 0}};
  return cloth;
}

Anchor AnyAnchor(const World& world) {
  Anchor anchor;
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      anchor.point = AnyVector();
      break;
    case 1:
      anchor.on = AnchorKind::kBody;
      anchor.index = *rc::gen::inRange(0, static_cast<int>(world.bodies.size()));
      anchor.point = Maybe() ? AnyVector() : Eigen::Vector3d(0, 0, Maybe() ? 0.0 : -0.0);
      break;
    default:
      anchor.on = AnchorKind::kParticle;
      anchor.index = *rc::gen::inRange(0, static_cast<int>(world.particles.size()));
  }
  return anchor;
}

Claim AnyClaim() {
  Claim claim;
  claim.law = *rc::gen::element<std::string>("ballistic", "0");
  if (Maybe()) claim.about = {"net", "Z-9"};
  if (Maybe()) claim.numbers = {{"length", AnyNumber()}, {"0", AnyNumber()}};
  if (Maybe()) claim.because = AnyText();
  return claim;
}

WorldScenario AnyWorldScenario() {
  WorldScenario scenario;
  scenario.id = "world/any";
  scenario.title = AnyText();
  scenario.source = AnyText();
  World& world = scenario.world;
  // Not in alphabetical order.
  world.bodies = {AnyBody("Z-9"), AnyBody("a"), AnyBody("M")};
  world.particles = {AnyParticle("y"), AnyParticle("0x1")};
  world.cloths = {AnyCloth("net")};
  const int ties = *rc::gen::inRange(0, 5);
  for (int i = 0; i < ties; ++i) {
    const Anchor A = AnyAnchor(world);
    const Anchor B = AnyAnchor(world);
    if (!FaultsOfEnds(world, A, B).empty()) continue;
    if (Maybe()) {
      world.joints.push_back({A, B, AnySize()});
    } else {
      world.springs.push_back(
          {A, B, AnyNotNegative(), AnyNotNegative(), AnyNotNegative()});
    }
  }
  world.gravity_W = AnyVector();
  world.dt = *rc::gen::element(1e-3, 1.0 / 240, 1.0 / 3);
  world.sample_every = *rc::gen::inRange(1, 9);
  world.steps = world.sample_every * *rc::gen::inRange(1, 999);
  if (world.bodies[1].mass != 0) {
    const int step = *rc::gen::inRange(0, world.steps);
    world.pushes.push_back({1, step * world.dt, AnyVector(), AnyVector()});
  }
  const int claims = *rc::gen::inRange(0, 3);
  for (int i = 0; i < claims; ++i) scenario.claims.push_back(AnyClaim());
  if (Maybe()) scenario.horizon = AnyNotNegative();
  if (Maybe()) {
    scenario.ensemble = {*rc::gen::inRange(2, 9), AnyLength(),
                         std::numeric_limits<unsigned>::max()};
  }
  if (Maybe()) scenario.indicts = {{AnyText(), AnyMeasures(), AnyText(), Maybe()}};
  return scenario;
}

RC_GTEST_PROP(WriteWorldScenario, IsReadBackBitForBit, ()) {
  const WorldScenario scenario = AnyWorldScenario();
  for (const Fault& fault : FaultsOf(scenario)) RC_FAIL(fault.where + ' ' + fault.what);
  RC_CLASSIFY(!scenario.world.springs.empty(), "springs");
  RC_CLASSIFY(!scenario.world.joints.empty(), "joints");
  RC_CLASSIFY(!scenario.world.pushes.empty(), "pushes");
  const std::string text = WriteScenario(scenario);
  RC_LOG() << text;
  const ReadResult read = ReadScenario(text, "f.toml");
  for (const Diagnostic& diagnostic : read.diagnostics) RC_LOG() << ToString(diagnostic);
  RC_ASSERT(read.world.has_value());
  RC_ASSERT(SameBits(*read.world, scenario));
  RC_ASSERT(WriteScenario(*read.world) == text);
}

TEST(WriteWorldScenario, OmitsAbsentValues) {
  WorldScenario scenario;
  scenario.id = "a";
  scenario.title = "b";
  scenario.source = "c";
  scenario.world.bodies.resize(1);
  scenario.world.bodies[0].name = "ball";
  scenario.world.bodies[0].placed = {
      Sphere{0.1}, Pose::FromQuaternion({0, 1, 0}, Eigen::Quaterniond::Identity())};
  scenario.world.joints = {
      {{AnchorKind::kWorld, -1, {0, 3, 0}}, {AnchorKind::kBody, 0, {0, 0.1, 0}}, 1.9}};
  EXPECT_EQ(WriteScenario(scenario), R"(id = "a"
title = "b"
source = "c"

[world]
gravity = [0.0, -9.82, 0.0]
dt = 0.004166666666666667
steps = 240
sample_every = 1

[bodies.ball]
shape = "sphere"
radius = 0.1
position = [0.0, 1.0, 0.0]
quaternion = [1.0, 0.0, 0.0, 0.0]
mass = 1.0
restitution = 0.5
friction = 0.6

[[joints]]
A = [0.0, 3.0, 0.0]
B = {on = "ball", point = [0.0, 0.1, 0.0]}
length = 1.9
)");
}

}  // namespace
}  // namespace touchstone
