#include "scenarios/generators/crowds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/referee/referee.h"
#include "scenarios/worlds/validate_world.h"

namespace touchstone {
namespace {

using testing::IsEmpty;

int MovingBodies(const World& world) {
  int moving = 0;
  for (const RigidBody& body : world.bodies) moving += body.mass > 0 ? 1 : 0;
  return moving;
}

TEST(Crowds, HaveTheRequestedNumberOfBodiesAndCanBeSimulated) {
  for (const World& world : {BoxPile(150, 1), SpherePile(150, 1), BoxStack(150)}) {
    EXPECT_EQ(MovingBodies(world), 150);
    EXPECT_THAT(FaultsOf(world), IsEmpty());
  }
}

TEST(Crowds, StartWithoutContactInPiles) {
  for (const World& world : {BoxPile(100, 3), SpherePile(100, 3)}) {
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
      for (std::size_t j = i + 1; j < world.bodies.size(); ++j) {
        const RigidBody& a = world.bodies[i];
        const RigidBody& b = world.bodies[j];
        const bool near = (a.placed.X_WB.p_WB - b.placed.X_WB.p_WB).norm() < 2;
        if (!near && a.mass > 0) continue;
        EXPECT_EQ(ComputeContactTruth({a.placed, b.placed}).touching, Touching::kApart)
            << a.name << " and " << b.name;
      }
    }
  }
}

TEST(Crowds, DependOnlyOnTheirSeed) {
  const World one = BoxPile(20, 1);
  const World again = BoxPile(20, 1);
  const World other = BoxPile(20, 2);
  EXPECT_EQ(one.bodies[7].placed.X_WB.p_WB, again.bodies[7].placed.X_WB.p_WB);
  EXPECT_NE(one.bodies[7].placed.X_WB.p_WB, other.bodies[7].placed.X_WB.p_WB);
}

TEST(Crowds, StandOnOneAnotherInAStack) {
  const World world = BoxStack(20);
  double top = 0;
  for (const RigidBody& body : world.bodies) {
    if (body.mass == 0) continue;
    const double half = std::get<Box>(body.placed.shape).half_extents.y();
    EXPECT_DOUBLE_EQ(body.placed.X_WB.p_WB.y() - half, top);
    top = body.placed.X_WB.p_WB.y() + half;
  }
}

}  // namespace
}  // namespace touchstone
