#include "engine/dynamics/body/rotation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include <gtest/gtest.h>

#include "engine/dynamics/world/world.h"
#include "tests/engine/dynamics/random.h"

namespace cookbook {
namespace {

/** The final state of the body of the "boxes" benchmark (Peters & Hsu 2014), which
 tumbles as in its complex case. */
struct Tumbling {
  Eigen::Vector3d L_W;
  Eigen::Quaterniond q_WB;
  double energy;
};

const Eigen::Vector3d kMoments =
    10.0 / 12 *
    Eigen::Vector3d(0.4 * 0.4 + 0.9 * 0.9, 0.1 * 0.1 + 0.9 * 0.9, 0.1 * 0.1 + 0.4 * 0.4);
const Eigen::Vector3d kOmega(0.1, 5, 0.1);

Tumbling After10s(double h) {
  Settings settings;
  settings.gravity_W.setZero();
  World world(settings);
  BodyDefinition box;
  box.shape = Box{{0.05, 0.2, 0.45}};
  box.mass = 10;
  box.state.w_WB = kOmega;
  world.AddBody(box);
  const int steps = static_cast<int>(std::lround(10 / h));
  for (int k = 0; k < steps; ++k) world.Step(h);
  const BodyState& end = world.state(0);
  const Eigen::Vector3d w_B = end.q_WB.conjugate() * end.w_WB;
  return {end.q_WB * kMoments.cwiseProduct(w_B).eval(), end.q_WB,
          0.5 * w_B.dot(kMoments.cwiseProduct(w_B))};
}

TEST(Rotation, ATumblingBoxKeepsItsAngularMomentumToRounding) {
  const Eigen::Vector3d L = kMoments.cwiseProduct(kOmega);
  const Tumbling end = After10s(1e-2);
  EXPECT_LT((end.L_W - L).norm(), 16 * 1000 * 0x1p-53 * L.norm());
}

TEST(Rotation, ATumblingBoxConvergesWithFourthOrderToJacobisEllipticFunctions) {
  // The closed form in Jacobi's elliptic functions.
  const Eigen::Quaterniond truth(0.225164563, -0.619927563, -0.277029151, 0.698745724);
  const double coarse = After10s(4e-2).q_WB.angularDistance(truth);
  const double fine = After10s(2e-2).q_WB.angularDistance(truth);
  const double finest = After10s(4e-3).q_WB.angularDistance(truth);
  EXPECT_LT(fine, 3e-5);
  EXPECT_GT(std::log2(coarse / fine), 3.7) << coarse << " " << fine;
  EXPECT_LT(finest, coarse / 9e3) << "ten times finer";
}

// The maximum number of sub-steps is too small here.
TEST(Rotation, ABodyThatTurnsTooFastToResolveStillGetsItsWholeTorque) {
  const Eigen::Vector3d moments(1e-6, 1, 1);
  const Eigen::Vector3d L_W(3e4, 2e4, 1e4);
  const Eigen::Vector3d dL_W(100, -200, 300);
  const Eigen::Quaterniond q = Eigen::Quaterniond(0.8, 0.4, 0.4, 0.2).normalized();
  const AngularState end = IntegrateAngularMomentum({q, Eigen::Vector3d::Zero()}, moments,
                                                    L_W, {dL_W, {}}, 0.1);
  const Eigen::Vector3d L_B = moments.cwiseProduct(end.q_WB.conjugate() * end.w_WB);
  EXPECT_LE((end.q_WB * L_B - (L_W + dL_W)).norm(), 1e-9 * L_W.norm());
}

// The rod turns by more than half a radian per step, and its moments differ by a factor
// of 100.
TEST(Rotation, AThinRodThatTumblesFastKeepsItsEnergy) {
  Settings settings;
  settings.gravity_W.setZero();
  World world(settings);
  BodyDefinition rod;
  rod.shape = Box{{0.5, 0.05, 0.005}};
  rod.state.w_WB = {2, 0.1, 38};
  world.AddBody(rod);
  const Eigen::Vector3d moments = PrincipalInertia(rod.shape, rod.mass);
  const auto energy = [&] {
    const BodyState& state = world.state(0);
    const Eigen::Vector3d w_B = state.q_WB.conjugate() * state.w_WB;
    return w_B.dot(moments.cwiseProduct(w_B)) / 2;
  };
  const double start = energy();
  for (int k = 0; k < 60; ++k) world.Step(1.0 / 60);
  EXPECT_NEAR(energy(), start, 60 * 16 * 0x1p-53 * start);
}

TEST(Rotation, AboutAPrincipalAxisIsExact) {
  Settings settings;
  settings.gravity_W.setZero();
  World world(settings);
  BodyDefinition box;
  box.shape = Box{{0.05, 0.2, 0.45}};
  box.state.w_WB = {0.5, 0, 0};
  world.AddBody(box);
  for (int k = 0; k < 1000; ++k) world.Step(1e-2);
  const Eigen::Quaterniond truth(std::cos(2.5), std::sin(2.5), 0, 0);
  EXPECT_LT(world.state(0).q_WB.angularDistance(truth), 1000 * 16 * 0x1p-53);
}

// At rest there is no direction of angular momentum. The torque across a bar turns it
// about one of two axes of equal moments, so its energy is the same in a whole circle of
// orientations: rounding must not choose among them.
TEST(Rotation, ABarThatATorqueTurnsFromRestTurnsByTheTorqueAlone) {
  const Eigen::Vector3d moments(0.0116, 0.144, 0.144);
  const double h = 1e-3;
  for (int k = 0; k < 1000; ++k) {
    const double angle = 0.1 * k;
    const AngularState start{
        Exp({angle, std::cos(3 * angle), std::sin(7 * angle)}).normalized(),
        Eigen::Vector3d::Zero()};
    const Eigen::Vector3d torque_B(0, std::cos(angle), std::sin(angle));
    const Eigen::Vector3d dL_W = start.q_WB * (0.02 * torque_B);
    const AngularState end = IntegrateAngularMomentum(
        start, moments, Eigen::Vector3d::Zero(), {dL_W, std::nullopt}, h);
    // ω grows at a constant rate to dL/I, so it turns by half of that times h. The energy
    // is level to second order, so its rounding is an angle of √(16 · 2^-53) at most.
    const Eigen::Vector3d phi_W = 0.5 * h * dL_W / moments.y();
    EXPECT_LT(end.q_WB.angularDistance(Exp(phi_W) * start.q_WB), 4 * 0x1p-26) << k;
  }
}

/** A body that turns by about `angle` in a step of 1 s, under forces that change that by
 as much. */
struct ForcedTurn {
  AngularState start;
  Eigen::Vector3d moments;
  Eigen::Vector3d L_W;
  Eigen::Vector3d dL_W;

  ForcedTurn(std::uint64_t seed, double angle) {
    Random random(seed);
    const bool is_bar = random.Coin();
    const double y = is_bar ? 0.05 : random.LogUniform(0.05, 1);
    const double z = is_bar ? 0.05 : random.LogUniform(0.05, 1);
    moments = {y * y + z * z, 1 + z * z, 1 + y * y};
    start.q_WB = random.Rotation();
    start.w_WB = angle * random.Direction();
    const Eigen::Matrix3d R = start.q_WB.toRotationMatrix();
    L_W = WorldInertiaTimes(R, moments, start.w_WB);
    const double change = random.Uniform(0, angle);
    const Eigen::Vector3d change_W = change * random.Direction();
    dL_W = WorldInertiaTimes(R, moments, change_W);
  }
  LeverArmState End(const Eigen::Vector3d& more_dL_W = Eigen::Vector3d::Zero()) const {
    return IntegrateWithLeverArms(start, moments, L_W, dL_W + more_dL_W, 1);
  }
};

// The work of forces at the mean arms is the change of energy, or the equation counts as
// unsolved. Undamped, Newton's method stopped far from the solution of bars of 1 : 20
// that turn by a third of a radian, and multiplied their energy by up to 200.
TEST(IntegrateWithLeverArms, KeepsTheWorkOfForcesAtAnyAngle) {
  for (const double angle : {0.1, 0.3, 1.0, 3.0}) {
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
      const ForcedTurn body(seed, angle);
      const LeverArmState end = body.End();
      ASSERT_TRUE(end.is_solved) << seed << " " << angle;
      // The Cayley map of x turns by 2 atan(|x|/2).
      const Eigen::Quaterniond turn = end.q_WB * body.start.q_WB.conjugate();
      const Eigen::Vector3d x_W = 2 / turn.w() * turn.vec();
      const double before = body.L_W.dot(body.start.w_WB) / 2;
      const double after = (body.L_W + body.dL_W).dot(end.w_WB) / 2;
      // Twice the tolerance of the solution.
      EXPECT_NEAR(after - before, body.dL_W.dot(x_W), 2e-12 * (before + after)) << seed;
    }
  }
}

TEST(LeverArmResponse, IsTheDerivativeOfTheRotation) {
  constexpr double kChange = 1e-6;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const ForcedTurn body(seed, 0.3);
    const LeverArmState end = body.End();
    const Eigen::Matrix3d response = LeverArmResponse(body.start, end, body.moments, 1);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d change_W = kChange * Eigen::Vector3d::Unit(axis);
      const Eigen::Quaterniond turn =
          body.End(change_W).q_WB * body.End(-change_W).q_WB.conjugate();
      const Eigen::Vector3d turn_W = 2 / turn.w() * turn.vec();
      // The derivative is that of a central difference to (3e-4)², as the thinnest bar
      // turns by 3e-4 rad for this change, and roundings of 1e-16 / 1e-6.
      EXPECT_LE((turn_W / (2 * kChange) - response.col(axis)).norm(),
                1e-7 * response.norm())
          << seed;
    }
  }
}

TEST(SpinAfterCorrection, KeepsTheEnergyAndTurnsTheMomentumByLittle) {
  for (std::uint64_t seed = 0; seed < 10000; ++seed) {
    Random random(seed);
    const double anisotropy = random.LogUniform(1e-6, 1e4);
    Eigen::Vector3d moments(1, 1 + anisotropy, 1 + random.Uniform(0, 1) * anisotropy);
    moments *= random.LogUniform(1e-3, 1e3);
    const Eigen::Matrix3d from = random.Rotation().toRotationMatrix();
    const double angle = random.LogUniform(1e-6, 0.05);
    const Eigen::Matrix3d to =
        Eigen::AngleAxisd(angle, random.Direction()).toRotationMatrix() * from;
    const Eigen::Vector3d w_from = random.LogUniform(0.1, 100) * random.Direction();
    const Eigen::Vector3d w_to = SpinAfterCorrection(from, to, moments, w_from);
    const Eigen::Vector3d L_from = WorldInertiaTimes(from, moments, w_from);
    const Eigen::Vector3d L_to = WorldInertiaTimes(to, moments, w_to);
    EXPECT_NEAR(w_to.dot(L_to) / w_from.dot(L_from), 1, 1e-11) << seed;
    // Turned, the momentum turns by the angle. Scaled, 2 E = L·I⁻¹L changes by at most
    // 2 θ |L|² (1/I_min − 1/I_max), and is at least |L|²/I_max.
    EXPECT_LE((L_to - L_from).norm(),
              1.2 * angle * std::min(1.0, anisotropy) * L_from.norm() + 1e-12)
        << seed;
  }
}

}  // namespace
}  // namespace cookbook
