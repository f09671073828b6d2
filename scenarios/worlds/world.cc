#include "scenarios/worlds/world.h"

#include <algorithm>
#include <array>

#include "scenarios/worlds/solid.h"

namespace touchstone {
namespace {

/** @pre The body is static if it is a half-space. */
WorldFeature FeatureOf(const RigidBody& body) {
  // Both lists have the order of ShapeKind.
  const WorldFeature sphere =
      body.mass == 0 ? WorldFeature::kStaticSphere : WorldFeature::kSphere;
  return static_cast<WorldFeature>(static_cast<int>(sphere) +
                                   static_cast<int>(KindOf(body.placed.shape)));
}

}  // namespace

World Refined(const World& world, int factor) {
  World refined = world;
  refined.dt /= factor;
  refined.steps *= factor;
  refined.sample_every *= factor;
  return refined;
}

Eigen::Vector3d InertiaOf(const RigidBody& body) {
  if (body.mass == 0) return Eigen::Vector3d::Zero();
  if (body.inertia) return *body.inertia;
  return *UniformMoments(body.placed.shape, body.mass);
}

Eigen::Vector3d StartOf(const World& world, const Anchor& anchor) {
  const auto index = static_cast<std::size_t>(anchor.index);
  switch (anchor.on) {
    case AnchorKind::kBody:
      return world.bodies[index].placed.X_WB * anchor.point;
    case AnchorKind::kParticle:
      return world.particles[index].p_W;
    case AnchorKind::kWorld:
      break;
  }
  return anchor.point;
}

std::string_view NameOf(WorldFeature feature) {
  static constexpr std::array<std::string_view, kWorldFeatures> kNames = {
      "sphere",
      "box",
      "capsule",
      "cylinder",
      "cone",
      "convex hull",
      "static sphere",
      "static box",
      "static capsule",
      "static cylinder",
      "static cone",
      "static convex hull",
      "static half-space",
      "stated inertia",
      "restitution",
      "friction",
      "unequal friction",
      "two moving bodies that may meet",
      "force",
      "particle",
      "spring",
      "distance joint",
      "cloth",
      "push"};
  return kNames[static_cast<std::size_t>(feature)];
}

std::vector<WorldFeature> FeaturesOf(const World& world) {
  std::array<bool, kWorldFeatures> asked{};
  const auto ask = [&](WorldFeature feature, bool asks = true) {
    asked[static_cast<std::size_t>(feature)] |= asks;
  };
  const RigidBody* first = nullptr;
  int bouncing = 0;
  int rubbing = 0;
  int moving = 0;
  for (const RigidBody& body : world.bodies) {
    ask(WorldFeature::kForce, !body.force_W.isZero(0));
    ask(WorldFeature::kStatedInertia, body.inertia.has_value() && body.mass != 0);
    if (!body.collides) continue;
    ask(FeatureOf(body));
    if (body.restitution > 0) ++bouncing;
    if (body.friction > 0) ++rubbing;
    if (body.mass > 0) ++moving;
    if (!first) first = &body;
    ask(WorldFeature::kUnequalFriction, body.friction != first->friction);
  }
  ask(WorldFeature::kRestitution, bouncing > 1);
  ask(WorldFeature::kFriction, rubbing > 1);
  ask(WorldFeature::kMovingBodies, moving > 1);
  ask(WorldFeature::kParticle, !world.particles.empty());
  ask(WorldFeature::kSpring, !world.springs.empty());
  ask(WorldFeature::kDistanceJoint, !world.joints.empty());
  ask(WorldFeature::kCloth, !world.cloths.empty());
  ask(WorldFeature::kPush, !world.pushes.empty());
  std::vector<WorldFeature> features;
  for (int i = 0; i < kWorldFeatures; ++i) {
    if (asked[static_cast<std::size_t>(i)])
      features.push_back(static_cast<WorldFeature>(i));
  }
  return features;
}

}  // namespace touchstone
