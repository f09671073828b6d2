#include "reports/worlds/law_support/box_cone.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

/** Two contacts in each step. Their normal impulses are 1.5 and 0.5 N s, and each has the
 tangential impulse `J_t`. */
Trajectory TwoContacts(const World& world, const Eigen::Vector2d& J_t,
                       const Eigen::Vector3d& stated_W = Eigen::Vector3d::Zero()) {
  Trajectory trajectory = Sampled(world, [](double) { return WorldState{}; });
  trajectory.gives_impulses = true;
  for (int step = 1; step <= world.steps; ++step) {
    for (const double J_n : {1.5, 0.5}) {
      trajectory.impulses.push_back({.step = step,
                                     .A = 1,
                                     .B = 0,
                                     .p_WC = {J_n, 0, 0},
                                     .n_AB_W = {0, 1, 0},
                                     .J_B_W = {J_t.x(), J_n, J_t.y()},
                                     .t_W = stated_W});
    }
  }
  return trajectory;
}

bool Follows(const World& world, const Trajectory& trajectory) {
  OracleInfo oracle;
  oracle.name = "made";
  return FollowsBoxCone({world, oracle, trajectory});
}

TEST(FollowsBoxCone, SumsTheContactsOfAPatch) {
  // 0.5 N s is twice what the second contact may have; the two together have 1 of 2 N s.
  const World world = BallOnRoughGround();
  EXPECT_TRUE(Follows(world, TwoContacts(world, {0.5, 0.4})));
  EXPECT_TRUE(Follows(world, TwoContacts(world, {0.4, -0.5})));
}

TEST(FollowsBoxCone, NeedsAnImpulseOnTheBoxBeyondTheCircle) {
  const World world = BallOnRoughGround();
  EXPECT_FALSE(Follows(world, TwoContacts(world, {0.3, 0.4})));   // On the circle.
  EXPECT_FALSE(Follows(world, TwoContacts(world, {0.4, 0.4})));   // Inside the box.
  EXPECT_FALSE(Follows(world, TwoContacts(world, {0.51, 0.4})));  // Outside the box.
  EXPECT_FALSE(Follows(world, Trajectory()));
}

TEST(FollowsBoxCone, IsNotAboutDirectionsThatAnEngineTurns) {
  const World world = BallOnRoughGround();
  EXPECT_FALSE(Follows(world, TwoContacts(world, {0.5, 0.4}, {1, 0, 0})));
}

}  // namespace
}  // namespace touchstone
