#include <cmath>

#include <gtest/gtest.h>

#include "reports/worlds/truth/mechanics.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

World Struck(double dt = 1e-3) {
  World world;
  RigidBody box = BodyOf("box", Box{{0.3, 0.1, 0.2}}, 2, {0, 1, 0});
  box.placed.X_WB = Pose::FromQuaternion(
      {0, 1, 0}, Eigen::Quaterniond(0.8, 0.3, -0.2, 0.4).normalized());
  box.w_WB = {0.5, 1, -0.7};
  world.bodies = {box};
  world.pushes.push_back({0, 50 * dt, {0.3, 0.1, -0.2}, {0.4, 1.5, -0.8}});
  world.dt = dt;
  world.steps = 100;
  return world;
}

/** The push at the point `at` of the body, and explicit Euler steps. */
Trajectory Moved(const World& world, const Eigen::Vector3d& at, double size = 1) {
  int step = 0;
  return Stepped(world, [&world, at, size, step](WorldState& state) mutable {
    BodyState& is = state.bodies[0];
    const Eigen::Matrix3d I = InertiaInWorld(world.bodies[0], is.q_WB);
    if (step++ == 50) {
      const Eigen::Vector3d J = size * world.pushes[0].J_W;
      is.v_WB += J / 2;
      is.w_WB += I.inverse() * (is.q_WB * at).cross(J);
    }
    is.v_WB += world.dt * world.gravity_W;
    is.w_WB -= world.dt * I.inverse() * is.w_WB.cross(I * is.w_WB);
    is.p_WB += world.dt * is.v_WB;
    is.q_WB = Turned(is.q_WB, world.dt * is.w_WB);
  });
}

TEST(Pushed, APushAtItsPointPasses) {
  for (const int sample_every : {1, 4}) {
    World world = Struck();
    world.sample_every = sample_every;
    EXPECT_TRUE(
        Passes(Judge(world, Moved(world, world.pushes[0].p_BoP), ClaimOf("pushed"))))
        << sample_every;
  }
}

TEST(Pushed, FindsAPushThatIsWeakerOrElsewhere) {
  const World world = Struck();
  EXPECT_TRUE(Finds(Judge(world, Moved(world, {0.3, 0.1, 0.2}), ClaimOf("pushed")),
                    MeasureKind::kAngularMomentumDrift));
  EXPECT_TRUE(
      Finds(Judge(world, Moved(world, world.pushes[0].p_BoP, 0.999), ClaimOf("pushed")),
            MeasureKind::kMomentumDrift));
}

TEST(Pushed, FindsInertiaThatDoesNotRotateWithTheBody) {
  // The push in the world frame, divided by the inertia along the body's own axes.
  const World world = Struck();
  int step = 0;
  const Trajectory moved = Stepped(world, [&world, &step](WorldState& state) {
    BodyState& is = state.bodies[0];
    is.v_WB += world.dt * world.gravity_W;
    if (step++ == 50) {
      is.v_WB += world.pushes[0].J_W / 2;
      is.w_WB += (is.q_WB * world.pushes[0].p_BoP)
                     .cross(world.pushes[0].J_W)
                     .cwiseQuotient(InertiaOf(world.bodies[0]));
    }
  });
  EXPECT_TRUE(
      Finds(Judge(world, moved, ClaimOf("pushed")), MeasureKind::kAngularMomentumDrift));
}

TEST(Pushed, KnowsItsNumbersAndRefusesBodiesWithoutAPush) {
  World world = Struck();
  EXPECT_TRUE(FaultsOf(world, ClaimOf("pushed", {},
                                      {{"expected_speed_gain",
                                        std::sqrt(0.16 + 2.25 + 0.64) / 2}}))
                  .empty());
  world.pushes.clear();
  EXPECT_EQ(FaultsOf(world, ClaimOf("pushed")).size(), 1U);
}

TEST(TurnsOnce, pushed) {
  const World world = Struck();
  EXPECT_TRUE(TurnsOnce(world, Moved(world, world.pushes[0].p_BoP), ClaimOf("pushed")));
}

}  // namespace
}  // namespace touchstone
