#include "engine/dynamics/contacts/collide_bodies.h"

#include <gtest/gtest.h>

namespace cookbook {
namespace {

RigidBody SphereAt(double x, double radius, double mass) {
  BodyDefinition sphere;
  sphere.shape = Sphere{radius};
  sphere.state.p_WB = {x, 1, 2};
  sphere.mass = mass;
  return MakeRigidBody(sphere);
}

Manifold CollideWithoutMargin(const RigidBody& A, const RigidBody& B) {
  Manifold manifold;
  CollideSpeculative(0, A, B, Eigen::Vector3d::Zero(), manifold);
  return manifold;
}

/** Collides spheres of 0.5 and 0.25 m that overlap by 0.25 m: from x = 0.25 to 0.5. */
Manifold CollideWithMasses(double mass_A, double mass_B) {
  return CollideWithoutMargin(SphereAt(0, 0.5, mass_A), SphereAt(0.5, 0.25, mass_B));
}

TEST(CollideSpeculative, PutsTheContactOfTwoDynamicSpheresMidway) {
  const Manifold manifold = CollideWithMasses(1, 3);
  ASSERT_EQ(manifold.count, 1);
  EXPECT_EQ(manifold.n_AB_W, Eigen::Vector3d::UnitX());
  EXPECT_EQ(manifold.separation, -0.25);
  EXPECT_EQ(manifold.contacts[0].separation, -0.25);
  EXPECT_LT((manifold.contacts[0].p_WC - Eigen::Vector3d(0.375, 1, 2)).norm(), 1e-15);
}

// The lever arm of friction is the radius of the sphere, at any depth.
TEST(CollideSpeculative, PutsTheContactOnTheDynamicSphere) {
  const Manifold on_B = CollideWithMasses(0, 1);
  EXPECT_LT((on_B.contacts[0].p_WC - Eigen::Vector3d(0.25, 1, 2)).norm(), 1e-15);
  const Manifold on_A = CollideWithMasses(1, 0);
  EXPECT_LT((on_A.contacts[0].p_WC - Eigen::Vector3d(0.5, 1, 2)).norm(), 1e-15);
}

TEST(CollideSpeculative, FindsNoContactBeyondTheMargin) {
  const RigidBody A = SphereAt(0, 0.5, 1);
  const RigidBody B = SphereAt(1, 0.25, 1);
  Manifold manifold;
  CollideSpeculative(0.2, A, B, Eigen::Vector3d::Zero(), manifold);
  EXPECT_EQ(manifold.count, 0);
  EXPECT_FALSE(manifold.touching);
  EXPECT_EQ(manifold.separation, 0.25);
  CollideSpeculative(0.3, A, B, Eigen::Vector3d::Zero(), manifold);
  ASSERT_EQ(manifold.count, 1);
  EXPECT_EQ(manifold.contacts[0].separation, 0.25);
  EXPECT_LT((manifold.contacts[0].p_WC - Eigen::Vector3d(0.625, 1, 2)).norm(), 1e-15);
}

}  // namespace
}  // namespace cookbook
