#include "oracles/dart/dart_surfaces.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace touchstone {
namespace {

RigidBody Surface(double mass, double restitution, double friction) {
  RigidBody body;
  body.mass = mass;
  body.restitution = restitution;
  body.friction = friction;
  return body;
}

/* Expects that DART's combination rules, applied to `surfaces`, yield Touchstone's. */
void ExpectOurRules(const DartSurfaces& surfaces, const RigidBody& A,
                    const RigidBody& B) {
  EXPECT_NEAR(surfaces.RestitutionOf(A) * surfaces.RestitutionOf(B),
              std::min(A.restitution, B.restitution), 1e-15);
  EXPECT_NEAR(std::min(surfaces.FrictionOf(A), surfaces.FrictionOf(B)),
              std::sqrt(A.friction * B.friction), 1e-15);
}

TEST(DartSurfaces, YieldOurRulesIfAllMovingBodiesAreAlike) {
  World world;
  world.bodies = {Surface(1, 0.6, 0.5), Surface(2, 0.6, 0.5), Surface(0, 0.9, 0.3),
                  Surface(0, 0.2, 0.5)};
  const DartSurfaces surfaces(world);
  EXPECT_EQ(surfaces.why_not(), "");
  for (const RigidBody& B : world.bodies) ExpectOurRules(surfaces, world.bodies[0], B);
}

TEST(DartSurfaces, YieldOurRulesForASingleMovingBodyAgainstAnyStaticBody) {
  World world;
  world.bodies = {Surface(0, 0.9, 0.8), Surface(1, 0.6, 0.1), Surface(0, 0, 0.02)};
  const DartSurfaces surfaces(world);
  EXPECT_EQ(surfaces.why_not(), "");
  ExpectOurRules(surfaces, world.bodies[1], world.bodies[0]);
  ExpectOurRules(surfaces, world.bodies[1], world.bodies[2]);
}

TEST(DartSurfaces, YieldZeroForABodyWithoutRestitutionAndFriction) {
  World world;
  world.bodies = {Surface(0, 0.9, 0.8), Surface(1, 0, 0)};
  const DartSurfaces surfaces(world);
  EXPECT_EQ(surfaces.why_not(), "");
  ExpectOurRules(surfaces, world.bodies[1], world.bodies[0]);
}

TEST(DartSurfaces, StateWhyAWorldIsUnsupported) {
  World world;
  world.bodies = {Surface(1, 0.6, 0.5), Surface(1, 0.5, 0.5)};
  EXPECT_NE(DartSurfaces(world).why_not().find("restitution"), std::string::npos);
  world.bodies = {Surface(1, 0.6, 0.5), Surface(1, 0.6, 0.4)};
  EXPECT_NE(DartSurfaces(world).why_not().find("friction"), std::string::npos);
  world.bodies = {Surface(1, 0.6, 0.5), Surface(1, 0.6, 0.5), Surface(0, 0.6, 0.6)};
  EXPECT_NE(DartSurfaces(world).why_not().find("static bodies"), std::string::npos);
  for (RigidBody& body : world.bodies) body.collides = false;
  EXPECT_EQ(DartSurfaces(world).why_not(), "");
}

}  // namespace
}  // namespace touchstone
