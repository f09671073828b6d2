#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/dynamics/joints/spring_solver.h"
#include "engine/dynamics/world/world.h"

namespace cookbook {
namespace {

constexpr double kRounding = std::numeric_limits<double>::epsilon() / 2;

Settings Weightless() {
  Settings settings;
  settings.gravity_W.setZero();
  return settings;
}

BodyDefinition PointAt(const Eigen::Vector3d& p_W, double mass = 1) {
  BodyDefinition point;
  point.shape = Point{};
  point.mass = mass;
  point.state.p_WB = p_W;
  return point;
}

/** Simulates a bob of 1 kg on a spring of k = 100 N/m, so that ω₀ = 10 rad/s, released
 0.5 m from its rest position. Returns its displacement from there after 2 s. [m] */
double Oscillate(double h, double damping, bool fourth_order = true) {
  Settings settings = Weightless();
  settings.fourth_order_joints = fourth_order;
  World world(settings);
  const int bob = world.AddBody(PointAt({1.5, 0.3, -0.2}));
  world.AddSpring(
      {{-1, Eigen::Vector3d(0, 0.3, -0.2)}, {bob, {0, 0, 0}}, 100, damping, 1});
  const int steps = static_cast<int>(std::lround(2 / h));
  for (int k = 0; k < steps; ++k) world.Step(h);
  return world.state(bob).p_WB[0] - 1;
}

TEST(Spring, OscillatesAtItsNaturalFrequency) {
  // A step of length h advances the phase by 2 atan(ωh/2) = z − z³/12 + z⁵/80 − …, z =
  // ωh. Five sub-steps of the fractions c with Σc³ = 0 leave an error of Σc⁵ z⁵/80.
  const double s = 1 / (4 - std::cbrt(4.0));
  const double fifth = std::abs(4 * std::pow(s, 5) + std::pow(1 - 4 * s, 5)) / 80;
  for (const double h : {1.0 / 50, 1.0 / 240, 1e-3}) {
    const double phase_error =
        20 * std::pow(10 * h, 4) * fifth;  // Phase error after ωt = 20.
    EXPECT_NEAR(Oscillate(h, 0), 0.5 * std::cos(20.0), 0.5 * 1.5 * phase_error + 1e-12)
        << h;
  }
}

TEST(Spring, AStepOfSecondOrderAdvancesThePhaseByTwoArcTangents) {
  const double h = 1.0 / 100;
  const double phase = 200 * 2 * std::atan(10 * h / 2);
  EXPECT_NEAR(Oscillate(h, 0, false), 0.5 * std::cos(phase), 1e-11);
}

TEST(Spring, ADamperMakesTheOscillationDecay) {
  // x = A exp(−δt)(cos ωt + δ/ω sin ωt), δ = b/2m, ω² = ω₀² − δ².
  const double delta = 1;
  const double omega = std::sqrt(100 - delta * delta);
  const double truth = 0.5 * std::exp(-2 * delta) *
                       (std::cos(2 * omega) + delta / omega * std::sin(2 * omega));
  const double coarse = Oscillate(1.0 / 50, 2) - truth;
  const double fine = Oscillate(1.0 / 100, 2) - truth;
  EXPECT_LT(std::abs(coarse), 2e-5);
  EXPECT_NEAR(std::log2(std::abs(coarse / fine)), 4, 0.3);
}

TEST(Spring, ConservesEnergyAndMomentaAtAnyStiffness) {
  for (const double stiffness : {40.0, 400.0, 4e5}) {
    World world(Weightless());
    BodyDefinition a = PointAt({0.2, 0.5, -0.1}, 1);
    BodyDefinition b = PointAt({1.4, 0.7, 0.2}, 2);
    a.state.v_WB = {0.3, 1.1, -0.2};
    b.state.v_WB = {0.1, -0.9, 0.6};
    world.AddBody(a);
    world.AddBody(b);
    world.AddSpring({{0, {0, 0, 0}}, {1, {0, 0, 0}}, stiffness, 0, 1});
    const auto energy = [&] {
      const double stretch = (world.state(1).p_WB - world.state(0).p_WB).norm() - 1;
      return 0.5 * world.state(0).v_WB.squaredNorm() + world.state(1).v_WB.squaredNorm() +
             0.5 * stiffness * stretch * stretch;
    };
    const auto spin = [&] {
      return (world.state(0).p_WB.cross(world.state(0).v_WB) +
              2 * world.state(1).p_WB.cross(world.state(1).v_WB))
          .eval();
    };
    const double start = energy();
    const Eigen::Vector3d L = spin();
    const int steps = 500;
    for (int k = 0; k < steps; ++k) world.Step(1.0 / 240);
    // Five sub-steps of some ten roundings each; the solver stops within 1e-14 of the
    // greatest speed. At the last stiffness a step is two radians of the oscillation, and
    // the rounds end before the direction of the force has converged: still within 1e-5.
    const double rounding = stiffness > 1e5 ? 1e-5 : 5 * steps * (10 * kRounding + 1e-14);
    EXPECT_NEAR(energy(), start, rounding * start) << stiffness;
    EXPECT_LT((spin() - L).norm(), rounding * 5) << stiffness;
    const Eigen::Vector3d P = world.state(0).v_WB + 2 * world.state(1).v_WB;
    EXPECT_LT((P - a.state.v_WB - 2 * b.state.v_WB).norm(), rounding * 5) << stiffness;
  }
}

TEST(Spring, ConservesTheEnergyOfARingAtAnyStepSize) {
  // The tolerance of an impulse is a velocity, not the distance moved in a step.
  World world(Weightless());
  constexpr int kBalls = 6;
  for (int i = 0; i < kBalls; ++i) {
    const double turn = i * std::numbers::pi / 3;
    BodyDefinition ball = PointAt({std::cos(turn), 0.2, std::sin(turn)}, 0.5);
    ball.state.v_WB = {-1.5 * std::sin(turn), 0.1 * (i % 2), 1.5 * std::cos(turn)};
    world.AddBody(ball);
  }
  for (int i = 0; i < kBalls; ++i)
    world.AddSpring({{i, {0, 0, 0}}, {(i + 1) % kBalls, {0, 0, 0}}, 30, 0, 0.8});
  const auto energy = [&] {
    double sum = 0;
    for (int i = 0; i < kBalls; ++i) {
      const BodyState& one = world.state(i);
      const double stretch = (one.p_WB - world.state((i + 1) % kBalls).p_WB).norm() - 0.8;
      sum += 0.25 * one.v_WB.squaredNorm() + 15 * stretch * stretch;
    }
    return sum;
  };
  const double start = energy();
  const int steps = 500;
  for (int k = 0; k < steps; ++k) world.Step(1e-4);
  // Five sub-steps, each solved to 1e-14 of the greatest speed.
  EXPECT_NEAR(energy(), start, 5 * steps * (10 * kRounding + 1e-14) * start);
}

TEST(Spring, ADamperNeverAddsEnergyToAPairThatRotates) {
  World world(Weightless());
  BodyDefinition a = PointAt({0.2, 0.5, -0.1});
  BodyDefinition b = PointAt({1.4, 0.7, 0.2});
  a.state.v_WB = {0.3, 1.1, -0.2};
  b.state.v_WB = {0.1, -0.9, 0.6};
  world.AddBody(a);
  world.AddBody(b);
  world.AddSpring({{0, {0, 0, 0}}, {1, {0, 0, 0}}, 40, 0.8, 1});
  double last = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 500; ++k) {
    const double stretch = (world.state(1).p_WB - world.state(0).p_WB).norm() - 1;
    const double energy = 0.5 * world.state(0).v_WB.squaredNorm() +
                          0.5 * world.state(1).v_WB.squaredNorm() +
                          20 * stretch * stretch;
    EXPECT_LE(energy, last * (1 + 1e-13)) << k;
    last = energy;
    world.Step(1.0 / 240);
  }
}

TEST(Spring, ABoxHungByItsCornerConservesEnergy) {
  World world;
  BodyDefinition box;
  box.shape = Box{{0.1, 0.2, 0.3}};
  box.mass = 2;
  const int body = world.AddBody(box);
  const Eigen::Vector3d corner(0.1, 0.2, 0.3);
  world.AddSpring({{-1, Eigen::Vector3d(0.4, 1, 0.1)}, {body, corner}, 60, 0, 0.5});
  const Eigen::Vector3d moments = PrincipalInertia(box.shape, box.mass);
  const auto energy = [&] {
    const BodyState& state = world.state(body);
    const Eigen::Vector3d w_B = state.q_WB.conjugate() * state.w_WB;
    const double stretch =
        (state.p_WB + state.q_WB * corner - Eigen::Vector3d(0.4, 1, 0.1)).norm() - 0.5;
    return state.v_WB.squaredNorm() + 0.5 * w_B.dot(moments.cwiseProduct(w_B)) +
           2 * 9.82 * state.p_WB[1] + 30 * stretch * stretch;
  };
  const double start = energy();
  double worst = 0;
  for (int k = 0; k < 2400; ++k) {
    world.Step(1.0 / 240);
    worst = std::max(worst, std::abs(energy() - start));
  }
  // Its potential energy varies by about 20 J; (ωh)⁴ of the fastest oscillation, 20
  // rad/s, is 5e-5.
  EXPECT_LT(worst, 20 * 5e-5);
}

TEST(Spring, AStringHasTheLengthToWhichItsWeightStretchesIt) {
  // N links of rest length L₀ and stiffness k, a mass m at each: N L₀ + m g N (N + 1)/2k.
  World world;
  const int n = 10;
  int above = -1;
  for (int i = 1; i <= n; ++i) {
    BodyDefinition bead = PointAt({0, -0.1 * i, 0}, 0.05);
    bead.drag = 6;
    const int here = world.AddBody(bead);
    world.AddSpring({{above, {0, 0, 0}}, {here, {0, 0, 0}}, 500, 0, 0.1});
    above = here;
  }
  for (int k = 0; k < 4800; ++k) world.Step(1.0 / 240);
  const double length = n * 0.1 + 0.05 * 9.82 * n * (n + 1) / (2 * 500);
  EXPECT_NEAR(-world.state(above).p_WB[1], length, 1e-12);
}

TEST(Spring, RefusesInvalidSprings) {
  World world;
  world.AddBody(PointAt({0, 0, 0}));
  const Anchor at_world;
  const Anchor at_point{0, {0, 0, 0}};
  EXPECT_THROW(world.AddSpring({at_point, at_point, 1, 0, 1}), std::invalid_argument);
  EXPECT_THROW(world.AddSpring({at_world, {1, {0, 0, 0}}, 1, 0, 1}),
               std::invalid_argument);
  EXPECT_THROW(world.AddSpring({at_world, at_point, -1, 0, 1}), std::invalid_argument);
  EXPECT_THROW(world.AddSpring({at_world, at_point, 1, -1, 1}), std::invalid_argument);
  EXPECT_THROW(world.AddSpring({at_world, at_point, 1, 0, std::nan("")}),
               std::invalid_argument);
}

}  // namespace
}  // namespace cookbook
