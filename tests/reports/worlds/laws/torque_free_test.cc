#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "reports/worlds/truth/gyroscopic_schemes.h"
#include "reports/worlds/truth/jacobi_elliptic.h"
#include "reports/worlds/truth/mechanics.h"
#include "reports/worlds/truth/torque_free_rotation.h"
#include "tests/reports/worlds/motions.h"
#include "tests/reports/worlds/runge_kutta.h"

namespace touchstone {
namespace {

using Spin = Eigen::Matrix<double, 7, 1>;  // q (x, y, z, w), then ω in the body

/** Integrates Euler's equations and q̇ = ½ q ω by Runge-Kutta, without elliptic
 functions. */
Rotation IntegratedRotation(const Eigen::Vector3d& inertia, const Rotation& start,
                            double t, int steps) {
  Spin y;
  y << start.q_WB.coeffs(), start.q_WB.conjugate() * start.w_WB;
  y = Integrated(
      [&](const Spin& at) {
        const Eigen::Vector3d w = at.tail<3>();
        const Eigen::Quaterniond q(Eigen::Vector4d(at.head<4>()));
        Spin rate;
        rate << 0.5 * (q * Eigen::Quaterniond(0, w.x(), w.y(), w.z())).coeffs(),
            inertia.cwiseProduct(w).cross(w).cwiseQuotient(inertia);
        return rate;
      },
      y, t, steps);
  const Eigen::Quaterniond q(Eigen::Vector4d(y.head<4>().normalized()));
  return {q, q * Eigen::Vector3d(y.tail<3>())};
}

/** scpeters/benchmark, boxes "complex": inertia and spin of the box, near the
 separatrix. */
const Eigen::Vector3d kBoxInertia{0.80833333333333333, 0.68333333333333333,
                                  0.14166666666666667};
const Rotation kBoxStart{Eigen::Quaterniond::Identity(), {0.1, 5, 0.1}};

TEST(JacobiElliptic, HasTheKnownValues) {
  // Abramowitz & Stegun, example 16.7-1 and table 17.1.
  EXPECT_NEAR(Jacobi(0.20, 0.81, 0.19).sn, 0.19762, 5e-6);
  EXPECT_NEAR(CompleteEllipticK(0.5), 1.854074677301372, 1e-15);
  EXPECT_NEAR(CarlsonRF(1, 2, 0), 1.3110287771461, 1e-13);
}

TEST(JacobiElliptic, IsCircularAndHyperbolicAtTheEnds) {
  EXPECT_NEAR(Jacobi(0.7, 0, 1).sn, std::sin(0.7), 1e-15);
  EXPECT_NEAR(Jacobi(0.7, 1, 0).sn, std::tanh(0.7), 1e-15);
  EXPECT_NEAR(Jacobi(0.7, 1 - 1e-12, 1e-12).cn, 1 / std::cosh(0.7), 1e-11);
}

TEST(TorqueFreeRotation, AgreesWithThePublishedTable) {
  const TorqueFreeRotation truth(kBoxInertia, kBoxStart);
  const std::vector<double> times = {0.5, 3, 10};
  const std::vector<Rotation> at = truth.At(times);
  // Body spin and quaternion (w, x, y, z), computed with DOP853 at 3e-14.
  const Eigen::Vector3d w_10(2.755840405, -3.735963519, -3.161809003);
  const Eigen::Quaterniond q_10(0.225164563, -0.619927563, -0.277029151, 0.698745724);
  EXPECT_LE((at[2].q_WB.conjugate() * at[2].w_WB - w_10).norm(), 2e-8);
  EXPECT_LE(at[2].q_WB.angularDistance(q_10), 1e-8);
  const Eigen::Vector3d w_half(0.637305885, 4.941986289, 0.729135756);
  EXPECT_LE((at[0].q_WB.conjugate() * at[0].w_WB - w_half).norm(), 2e-9);
  EXPECT_NEAR(truth.period(), 6.056844158, 1e-9);
  EXPECT_NEAR(truth.angular_momentum(), 3.41765, 1e-5);
}

TEST(TorqueFreeRotation, AgreesWithIntegrationOnBothSidesOfTheSeparatrix) {
  const Eigen::Quaterniond q_WB =
      Turned(Eigen::Quaterniond::Identity(), {0.3, -1.1, 0.7});
  for (const Eigen::Vector3d& w_B :
       {Eigen::Vector3d(0.1, 5, 0.1), Eigen::Vector3d(3, 0.2, -0.4),
        Eigen::Vector3d(-0.3, 0.7, -4), Eigen::Vector3d(-1, -2, 3)}) {
    const Rotation start{q_WB, q_WB * w_B};
    const std::vector<double> times = {0.37, 1.9};
    const std::vector<Rotation> at = TorqueFreeRotation(kBoxInertia, start).At(times);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const Rotation slow = IntegratedRotation(kBoxInertia, start, times[i], 4000);
      EXPECT_LE(at[i].q_WB.angularDistance(slow.q_WB), 1e-10) << w_B.transpose();
      EXPECT_LE((at[i].w_WB - slow.w_WB).norm(), 1e-9) << w_B.transpose();
    }
  }
}

RC_GTEST_PROP(TorqueFreeRotation, AgreesWithIntegrationForAnyInertia, ()) {
  const auto from = [](int low, int high) {
    return *rc::gen::inRange(low, high) / 100.0;
  };
  // Sometimes two axes are alike: the symmetric top. Any two moments exceed the third.
  Eigen::Vector3d inertia(from(100, 200), from(100, 200), from(100, 200));
  if (*rc::gen::inRange(0, 3) == 0) inertia.y() = inertia.x();
  if (*rc::gen::inRange(0, 3) == 0) inertia.z() = inertia.y();
  const Eigen::Vector3d w(from(-300, 300), from(-300, 300), from(-300, 300));
  const Rotation start{Turned(Eigen::Quaterniond::Identity(), {0.4, 0.5, -0.6}), w};
  const std::vector<double> times = {1.3};
  const Rotation at = TorqueFreeRotation(inertia, start).At(times).front();
  const Rotation slow = IntegratedRotation(inertia, start, times[0], 1000);
  RC_ASSERT(at.q_WB.angularDistance(slow.q_WB) < 1e-8);
  RC_ASSERT((at.w_WB - slow.w_WB).norm() < 1e-8);
}

World TumblingBox(double dt) {
  World world;
  RigidBody box = BodyOf("box", Box{{0.05, 0.2, 0.45}}, 10, {0, 0, 0});
  box.w_WB = {0.1, 5, 0.1};
  world.bodies = {box};
  world.dt = dt;
  world.steps = static_cast<int>(std::lround(3 / dt));
  return world;
}

Trajectory Turning(const World& world, GyroscopicScheme scheme) {
  SteppedRotation stepped(scheme, InertiaOf(world.bodies[0]),
                          {Eigen::Quaterniond::Identity(), world.bodies[0].w_WB},
                          world.dt);
  return Stepped(world, [&, stepped](WorldState& state) mutable {
    stepped.Step();
    state.bodies[0].q_WB = stepped.state().q_WB;
    state.bodies[0].w_WB = stepped.state().w_WB;
  });
}

Trajectory TrueTurning(const World& world) {
  const TorqueFreeRotation truth(InertiaOf(world.bodies[0]),
                                 {Eigen::Quaterniond::Identity(), world.bodies[0].w_WB});
  return Sampled(world, [&](double t) {
    const std::vector<double> times = {t};
    const Rotation at = truth.At(times).front();
    return WorldState{{{{0, 0, 0}, at.q_WB, {0, 0, 0}, at.w_WB}}, {}, {}};
  });
}

/** Rotates at the initial spin: the gyroscopic term is missing. */
Trajectory TurningSteadily(const World& world) {
  return Stepped(world, [&](WorldState& state) {
    state.bodies[0].q_WB = Turned(state.bodies[0].q_WB, world.dt * state.bodies[0].w_WB);
  });
}

TEST(TorqueFree, TheTruthAndEverySchemePass) {
  const World world = TumblingBox(1e-3);
  EXPECT_TRUE(Passes(Judge(world, TrueTurning(world), ClaimOf("torque_free"))));
  for (const GyroscopicScheme scheme : kGyroscopicSchemes) {
    EXPECT_TRUE(Passes(Judge(world, Turning(world, scheme), ClaimOf("torque_free"))))
        << NameOf(scheme);
  }
}

TEST(TorqueFree, FindsAMissingGyroscopicTerm) {
  const World world = TumblingBox(1e-3);
  EXPECT_TRUE(Finds(Judge(world, TurningSteadily(world), ClaimOf("torque_free")),
                    MeasureKind::kOrientationError));
}

TEST(TorqueFree, KnowsThatSchemesHaveLostTheBody) {
  // The tolerance is that of such schemes. It passes an error that cannot be called
  // right.
  const World world = TumblingBox(0.04);
  const std::vector<LawFinding> findings =
      Judge(world, Turning(world, GyroscopicScheme::kImplicit), ClaimOf("torque_free"));
  EXPECT_TRUE(Passes(findings));
  EXPECT_GT(Of(findings, MeasureKind::kOrientationError).largest.value, 1);
  EXPECT_GT(Of(findings, MeasureKind::kSpinError).largest.value, 1);
}

TEST(TorqueFree, FindsInertiaThatDoesNotRotateWithTheBody) {
  const World world = TumblingBox(1e-3);
  const Eigen::Vector3d inertia = InertiaOf(world.bodies[0]);
  const Trajectory wrong = Stepped(world, [&](WorldState& state) {
    BodyState& body = state.bodies[0];
    const Eigen::Vector3d L = inertia.cwiseProduct(body.w_WB);
    body.w_WB -= world.dt * body.w_WB.cross(L).cwiseQuotient(inertia);
    body.q_WB = Turned(body.q_WB, world.dt * body.w_WB);
  });
  EXPECT_TRUE(
      Finds(Judge(world, wrong, ClaimOf("torque_free")), MeasureKind::kOrientationError));
}

TEST(TorqueFree, ASteadySpinMayOnlyHaveTheErrorOfItsQuaternion) {
  // About a principal axis the only error is ω³ h² t/12.
  World world = TumblingBox(1e-3);
  world.bodies[0].w_WB = {0.5, 0, 0};
  const auto slowed = [&](double share) {
    return Stepped(world, [&, share](WorldState& state) {
      BodyState& body = state.bodies[0];
      body.q_WB = Turned(body.q_WB, share * world.dt * body.w_WB);
    });
  };
  const Claim claim = ClaimOf("torque_free");
  EXPECT_TRUE(Passes(Judge(world, slowed(1), claim)));
  EXPECT_TRUE(
      Finds(Judge(world, slowed(1 - 1e-6), claim), MeasureKind::kOrientationError));
  const LawFinding euler =
      Of(Judge(world, Turning(world, GyroscopicScheme::kExplicit), claim),
         MeasureKind::kOrientationError);
  // The worst sample is not the last one: rounding takes more of the tolerance there.
  EXPECT_NEAR(euler.value, 0.125 * 1e-6 * 3 / 12, 0.1 * 0.125e-6 / 4);
}

TEST(TorqueFree, ComparesTheNumbersOfTheClaimWithItsOwn) {
  const World world = TumblingBox(1e-3);
  EXPECT_TRUE(FaultsOf(world, ClaimOf("torque_free", {},
                                      {{"expected_period", 6.056844158},
                                       {"expected_angular_momentum", 3.417653}}))
                  .empty());
  EXPECT_EQ(
      FaultsOf(world, ClaimOf("torque_free", {}, {{"expected_period", 6.0569}})).size(),
      1U);
}

TEST(ConservesAngularMomentum, TheTruthAndEverySchemePass) {
  for (const double dt : {1e-2, 1e-3}) {
    const World world = TumblingBox(dt);
    const Claim claim = ClaimOf("conserves_angular_momentum");
    EXPECT_TRUE(Passes(Judge(world, TrueTurning(world), claim)));
    for (const GyroscopicScheme scheme : kGyroscopicSchemes)
      EXPECT_TRUE(Passes(Judge(world, Turning(world, scheme), claim))) << NameOf(scheme);
  }
}

TEST(ConservesAngularMomentum, ItsRatesAreThoseOfTheSchemes) {
  // One step, so small that only the leading order remains.
  World world = TumblingBox(1e-5);
  world.bodies[0].w_WB = {3.4, 2.8, 3.9};
  world.steps = 1;
  const LawFinding linear =
      Of(Judge(world, Turning(world, GyroscopicScheme::kLinearlyImplicit),
               ClaimOf("conserves_angular_momentum")),
         MeasureKind::kAngularMomentumDrift);
  const LawFinding explicitly =
      Of(Judge(world, Turning(world, GyroscopicScheme::kExplicit),
               ClaimOf("conserves_angular_momentum")),
         MeasureKind::kAngularMomentumDrift);
  EXPECT_NEAR(std::max(linear.value, explicitly.value) / linear.tolerance.value, 1 / 1.5,
              1e-3);
}

TEST(ConservesAngularMomentum, GrantsBallsAtRestTheRoundingOfTheirPlacesAndNoMore) {
  World world;
  world.gravity_W.setZero();
  world.dt = 0.01;
  world.steps = 1;
  world.bodies = {BodyOf("a", Sphere{0.1}, 1, {1, 0, 0}),
                  BodyOf("b", Sphere{0.1}, 1, {3, 0, 0})};
  const auto moved = [&](double roundings) {
    return Sampled(world, [&](double t) {
      WorldState state = StateAtStart(world);
      // A place of 1 m is known to u, a velocity from places 0.01 s apart to u/0.01.
      if (t > 0) state.bodies[0].v_WB.y() = roundings * 0x1p-53 / world.dt;
      return state;
    });
  };
  const Claim claim = ClaimOf("conserves_angular_momentum");
  EXPECT_TRUE(Passes(Judge(world, moved(1), claim)));
  EXPECT_TRUE(Finds(Judge(world, moved(5), claim), MeasureKind::kAngularMomentumDrift));
}

TEST(ConservesAngularMomentum, FindsAMissingGyroscopicTerm) {
  const World world = TumblingBox(1e-3);
  EXPECT_TRUE(
      Finds(Judge(world, TurningSteadily(world), ClaimOf("conserves_angular_momentum")),
            MeasureKind::kAngularMomentumDrift));
}

TEST(ConservesEnergy, ATumblingBoxPassesByTheTruthAndEveryScheme) {
  for (const double dt : {1e-2, 1e-3}) {
    const World world = TumblingBox(dt);
    EXPECT_TRUE(Passes(Judge(world, TrueTurning(world), ClaimOf("conserves_energy"))));
    for (const GyroscopicScheme scheme : kGyroscopicSchemes) {
      EXPECT_TRUE(
          Passes(Judge(world, Turning(world, scheme), ClaimOf("conserves_energy"))))
          << NameOf(scheme);
    }
  }
}

TEST(TurnsOnce, torque_free) {
  World world = TumblingBox(1e-2);
  world.steps = 100;
  EXPECT_TRUE(TurnsOnce(world, TrueTurning(world), ClaimOf("torque_free")));
}

TEST(TurnsOnce, conserves_angular_momentum) {
  const World world = TumblingBox(1e-2);
  EXPECT_TRUE(
      TurnsOnce(world, TrueTurning(world), ClaimOf("conserves_angular_momentum")));
}

TEST(TurnsOnce, conserves_energy_of_a_tumbling_box) {
  const World world = TumblingBox(1e-2);
  EXPECT_TRUE(TurnsOnce(world, TrueTurning(world), ClaimOf("conserves_energy")));
}

}  // namespace
}  // namespace touchstone
