#include <vector>

#include <gtest/gtest.h>

#include "reports/worlds/truth/mechanics.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

constexpr double kRadius = 0.2;

/** A ball that slips on level ground, with friction to turn it. */
World Slipping() {
  World world;
  world.dt = 1e-3;
  world.steps = 100;
  world.bodies = {BodyOf("ball", Sphere{kRadius}, 2, {0, kRadius, 0}), GroundOf()};
  world.bodies[0].v_WB = {1, 0, 0};
  return world;
}

/** Semi-implicit Euler with sliding friction of 0.3. The spin gains `share` of what the
 friction gives. */
Trajectory Slipped(const World& world, double share = 1) {
  std::vector<ContactImpulse> impulses;
  int step = 0;
  const RigidBody& ball = world.bodies[0];
  const double weight = ball.mass * world.gravity_W.norm() * world.dt;
  Trajectory trajectory = Stepped(world, [&](WorldState& state) {
    BodyState& is = state.bodies[0];
    const Eigen::Vector3d r_W(0, -kRadius, 0);
    const Eigen::Vector3d J_W(-0.3 * weight, weight, 0);
    impulses.push_back({++step, 1, 0, is.p_WB + r_W, {0, 1, 0}, J_W, 0});
    is.v_WB += world.dt * world.gravity_W + J_W / ball.mass;
    is.w_WB += share * InertiaOf(ball).cwiseInverse().cwiseProduct(r_W.cross(J_W));
    is.p_WB += world.dt * is.v_WB;
    is.q_WB = Turned(is.q_WB, world.dt * is.w_WB);
  });
  trajectory.gives_impulses = true;
  trajectory.impulses = impulses;
  return trajectory;
}

TEST(AngularMomentumBalance, FrictionThatTurnsABallPasses) {
  World world = Slipping();
  for (const int sample_every : {1, 5}) {
    world.sample_every = sample_every;
    EXPECT_TRUE(Passes(Judge(world, Slipped(world), ClaimOf("angular_momentum_balance"))))
        << sample_every;
  }
}

TEST(AngularMomentumBalance, FindsASpinThatTheContactsDoNotGive) {
  const World world = Slipping();
  for (const double share : {0.9, 1.1, -1.0}) {
    EXPECT_TRUE(
        Finds(Judge(world, Slipped(world, share), ClaimOf("angular_momentum_balance")),
              MeasureKind::kAngularMomentumBalance))
        << share;
  }
}

/** A thin bar in free flight, which turns by 0.1 rad in a step. */
World ThinBar() {
  World world;
  world.dt = 0.01;
  world.steps = 20;
  world.gravity_W.setZero();
  world.bodies = {BodyOf("bar", Box{{0.3, 0.01, 0.01}}, 1, {0, 0, 0})};
  world.bodies[0].w_WB = {5, 8.66, 0};
  return world;
}

// Without gyroscopic torque the spin stays, and the angular momentum turns with the body.
TEST(AngularMomentumBalance, FindsAThinBarWithoutGyroscopicTorque) {
  const World world = ThinBar();
  Trajectory trajectory = Stepped(world, [&](WorldState& state) {
    BodyState& is = state.bodies[0];
    is.q_WB = Turned(is.q_WB, world.dt * is.w_WB);
  });
  trajectory.gives_impulses = true;
  EXPECT_TRUE(Finds(Judge(world, trajectory, ClaimOf("angular_momentum_balance")),
                    MeasureKind::kAngularMomentumBalance));
}

// A spin about the long axis of 100 roundings, times the ratio of the moments, comes and
// goes from step to step.
TEST(AngularMomentumBalance, GrantsTheRoundingOfASpinAboutAThinBar) {
  World world = ThinBar();
  world.bodies[0].w_WB = {0, 10, 0};
  const Eigen::Vector3d inertia = InertiaOf(world.bodies[0]);
  const double noise = 100 * 0x1p-53 * 10 * inertia.maxCoeff() / inertia.minCoeff();
  int step = 0;
  Trajectory trajectory = Stepped(world, [&](WorldState& state) {
    BodyState& is = state.bodies[0];
    is.q_WB = Turned(is.q_WB, world.dt * is.w_WB);
    const Eigen::Vector3d along_W = is.q_WB * Eigen::Vector3d::UnitX();
    is.w_WB = Eigen::Vector3d(0, 10, 0) + (++step % 2 ? noise : -noise) * along_W;
  });
  trajectory.gives_impulses = true;
  EXPECT_TRUE(Passes(Judge(world, trajectory, ClaimOf("angular_momentum_balance"))));
}

TEST(AngularMomentumBalance, GrantsTheLeverOfOneStepAndNoMore) {
  // Friction acts at a lever of 0.2 m. The normal impulse has none, but a point that is
  // off along the motion gives it one: 1 mm in a step of 1 ms at 1 m/s is legal.
  const World world = Slipping();
  const auto off = [&](double distance) {
    Trajectory trajectory = Slipped(world);
    for (ContactImpulse& contact : trajectory.impulses) contact.p_WC.x() += distance;
    return Judge(world, trajectory, ClaimOf("angular_momentum_balance"));
  };
  EXPECT_TRUE(Passes(off(0.001)));
  EXPECT_TRUE(Finds(off(0.005), MeasureKind::kAngularMomentumBalance));
}

// In a step the ball moves by 1 mm, and friction acts at the centre that it had before.
TEST(AngularMomentumBalance, TakesTheCentreThatExplainsTheLevers) {
  const World world = Slipping();
  const auto error = [&](double share) {
    const LawFinding found =
        Of(Judge(world, Slipped(world, share), ClaimOf("angular_momentum_balance")),
           MeasureKind::kAngularMomentumBalance);
    return found.value / found.tolerance.value;
  };
  EXPECT_LE(error(1), 1e-9);
  EXPECT_GE(error(0.9), 1);
}

TEST(AngularMomentumBalance, CountsAPushAtItsLever) {
  World world;
  world.bodies = {BodyOf("ball", Sphere{kRadius}, 2, {0, 1, 0})};
  world.pushes.push_back({0, 5 * world.dt, {0, 0.1, 0}, {0.4, 0, 0}});
  int step = 0;
  Trajectory pushed = Stepped(world, [&](WorldState& state) {
    BodyState& is = state.bodies[0];
    if (step++ == 5) is.w_WB = Eigen::Vector3d(0, 0, -0.04 / (0.4 * 2 * 0.04));
    is.v_WB += world.dt * world.gravity_W;
    is.p_WB += world.dt * is.v_WB;
  });
  pushed.gives_impulses = true;
  EXPECT_TRUE(Passes(Judge(world, pushed, ClaimOf("angular_momentum_balance"))));
  world.pushes[0].J_W *= 1.001;
  EXPECT_TRUE(Finds(Judge(world, pushed, ClaimOf("angular_momentum_balance")),
                    MeasureKind::kAngularMomentumBalance));
}

TEST(AngularMomentumBalance, JudgesNoEngineWithoutImpulsesAndNoHeldBody) {
  World world = Slipping();
  Trajectory silent = Slipped(world);
  silent.gives_impulses = false;
  EXPECT_TRUE(Judge(world, silent, ClaimOf("angular_momentum_balance")).empty());
  world.springs = {{{AnchorKind::kBody, 0, {0, 0, 0}}, {}, 1, 0, 1}};
  EXPECT_EQ(FaultsOf(world, ClaimOf("angular_momentum_balance")).size(), 1U);
}

TEST(AngularMomentumBalance, GrantsNoSeparationThatTheBodiesDoNotHave) {
  const World world = Slipping();
  for (const double lie : {-0.5, 0.5}) {
    Trajectory trajectory = Slipped(world, 0.9);
    for (ContactImpulse& contact : trajectory.impulses) contact.separation = lie;
    EXPECT_TRUE(Finds(Judge(world, trajectory, ClaimOf("angular_momentum_balance")),
                      MeasureKind::kAngularMomentumBalance))
        << lie;
  }
}

TEST(AngularMomentumBalance, GrantsTheDepthThatTheBodiesHave) {
  // Impulses that act at the bottom of the ball, or at the surface of the ground above
  // it.
  World world = Slipping();
  constexpr double kDepth = 0.01;
  world.bodies[0].placed.X_WB.p_WB.y() -= kDepth;
  Trajectory trajectory = Slipped(world);
  for (ContactImpulse& contact : trajectory.impulses) {
    contact.separation = -kDepth;
    contact.p_WC.y() += kDepth;
  }
  EXPECT_TRUE(Passes(Judge(world, trajectory, ClaimOf("angular_momentum_balance"))));
}

TEST(AngularMomentumBalance, GrantsNoLeverBeyondTheBody) {
  // Moving the point along the impulse changes no moment. The body is not isotropic, so a
  // long lever would be granted as turning with the body.
  World world = Slipping();
  world.bodies[0].inertia = Eigen::Vector3d(0.02, 0.03, 0.032);
  const auto judged = [&](double share, double along) {
    Trajectory trajectory = Slipped(world, share);
    for (ContactImpulse& contact : trajectory.impulses)
      contact.p_WC += along * contact.J_B_W.normalized();
    return Judge(world, trajectory, ClaimOf("angular_momentum_balance"));
  };
  EXPECT_TRUE(Passes(judged(1, 0)));
  EXPECT_TRUE(Finds(judged(0.9, 1000), MeasureKind::kAngularMomentumBalance));
}

TEST(AngularMomentumBalance, GrantsPositionCorrectionTheTurnOfItsDepthAndNoMore) {
  // A contact at the centre has no lever: correcting it turns nothing.
  World world = Slipping();
  world.bodies[0].inertia = Eigen::Vector3d(0.02, 0.03, 0.032);
  world.bodies[0].w_WB.z() = 5;
  Trajectory trajectory = Slipped(world, 0);
  for (std::size_t i = 0; i < trajectory.impulses.size(); ++i) {
    ContactImpulse& contact = trajectory.impulses[i];
    contact.p_WC = (trajectory.samples[i].bodies[0].p_WB +
                    trajectory.samples[i + 1].bodies[0].p_WB) /
                   2;
    contact.separation = -1e-9;
  }
  for (std::size_t s = 0; s < trajectory.samples.size(); ++s)
    trajectory.samples[s].bodies[0].w_WB.z() = s % 2 == 0 ? 5 : 4.8;
  EXPECT_TRUE(Finds(Judge(world, trajectory, ClaimOf("angular_momentum_balance")),
                    MeasureKind::kAngularMomentumBalance));
}

TEST(TurnsOnce, angular_momentum_balance) {
  const World world = Slipping();
  EXPECT_TRUE(TurnsOnce(world, Slipped(world), ClaimOf("angular_momentum_balance")));
}

}  // namespace
}  // namespace touchstone
