#include "engine/dynamics/body/rotation.h"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/dynamics/world/world.h"

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

}  // namespace
}  // namespace cookbook
