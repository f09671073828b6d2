#include "engine/dynamics/contacts/collide_bodies.h"

#include <cmath>
#include <numbers>

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

/** Collides the half-space below z = 0 with a box of 0.4 × 0.2 × 0.1 m, tilted about x,
 whose centre is at the height `z`. */
Manifold CollideWithGround(double tilt, double z) {
  BodyDefinition ground;
  ground.shape = HalfSpace{};
  ground.mass = 0;
  BodyDefinition box;
  box.shape = Box{{0.2, 0.1, 0.05}};
  box.state.q_WB = Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX());
  box.state.p_WB.z() = z;
  return CollideWithoutMargin(MakeRigidBody(ground), MakeRigidBody(box));
}

TEST(CollideSpeculative, FindsOnlyTheLowerFaceOfABoxThatHasSunk) {
  const double tilt = 0.1;
  const Manifold manifold = CollideWithGround(tilt, -0.3);
  ASSERT_EQ(manifold.count, 4);
  for (const ContactPoint& contact : manifold.points()) {
    // 0.05 m below the centre, along the axis of the box.
    const Eigen::Vector3d p_W = contact.p_WC - Eigen::Vector3d(0, 0, -0.3);
    const Eigen::Vector3d down(0, std::sin(tilt), -std::cos(tilt));
    EXPECT_NEAR(down.dot(p_W), 0.05, 1e-15);
    EXPECT_NEAR(contact.separation, contact.p_WC.z(), 1e-15);
  }
}

// Two faces look at the ground alike: a mirror image has the same contacts.
TEST(CollideSpeculative, FindsBothLowerFacesOfASunkBoxThatStandsOnItsEdge) {
  EXPECT_EQ(CollideWithGround(std::numbers::pi / 4, -0.3).count, 6);
}

}  // namespace
}  // namespace cookbook
