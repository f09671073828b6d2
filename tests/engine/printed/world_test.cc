// The published recipes of motion. Corrected, they obey the laws of mechanics; each
// erratum alone breaks the law that it concerns. The figures are those of the
// specification.
#include "engine/printed/world.h"

#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cookbook::printed {
namespace {

using Eigen::Vector3d;

// A bound on the rounding of some hundred steps of a dozen operations each.
constexpr double kRounding = 1e-12;

Settings Weightless() {
  return {.gravity_W = Vector3d::Zero()};
}

Body Ball(double mass) {
  Body ball;
  ball.shape = Sphere{0.5};
  ball.mass = mass;
  return ball;
}

Body Slab() {
  Body slab;
  slab.shape = Box{{0.1, 0.5, 1}};
  slab.mass = 2;
  return slab;
}

Body Floor() {
  Body floor;
  floor.shape = Box{{50, 1, 50}};
  floor.p_WB = {0, -1, 0};
  floor.mass = 0;
  return floor;
}

Vector3d AngularMomentum(const Body& body) {
  const Eigen::Matrix3d R = body.q_WB.toRotationMatrix();
  return R * body.inertia.cwiseProduct(R.transpose() * body.w_WB);
}

void Run(World& world, double dt, int steps) {
  for (int i = 0; i < steps; ++i) world.Step(dt);
}

double SpeedAfter(const Errata& errata, double dt, int steps) {
  World world(errata, Weightless());
  Body ball = Ball(1);
  ball.v_WB = {1, 0, 0};
  world.Add(ball);
  Run(world, dt, steps);
  return world.bodies()[0].v_WB.x();
}

TEST(PrintedWorld, KeepsTheVelocityOfFreeFlightWhenCorrected) {
  EXPECT_EQ(SpeedAfter(Errata::None(), 1.0 / 60, 60), 1);
}

TEST(PrintedWorld, LosesVelocityPerStepUnderE11) {
  EXPECT_NEAR(SpeedAfter({Erratum::kE11}, 1.0 / 60, 60), 0.30, 0.005);
  EXPECT_NEAR(SpeedAfter({Erratum::kE11}, 1.0 / 100, 100), 0.13, 0.005);
}

Vector3d VelocityAfterImpulse(const Errata& errata) {
  World world(errata, Weightless());
  world.Add(Ball(10));
  world.ApplyImpulse(0, Vector3d::Zero(), {20, 0, 0});
  return world.bodies()[0].v_WB;
}

TEST(PrintedWorld, DividesAnImpulseByTheMassButNotUnderE10) {
  EXPECT_NEAR(VelocityAfterImpulse(Errata::None()).x(), 2, kRounding);
  EXPECT_NEAR(VelocityAfterImpulse({Erratum::kE10}).x(), 20, kRounding);
}

// The speed of a box some steps after it lands flat on four contacts at 4 m/s, e = 0.5.
double SpeedAfterLanding(const Errata& errata, int steps) {
  World world(errata, Weightless());
  Body box;
  box.shape = Box{{0.5, 0.5, 0.5}};
  box.p_WB = {0.1, 0.4999, -0.2};
  box.v_WB = {0, -4, 0};
  world.Add(Floor());
  world.Add(box);
  Run(world, 1e-5, steps);
  return world.bodies()[1].v_WB.y();
}

TEST(PrintedWorld, BouncesOffFourContactsButNotUnderE12) {
  // Five iterations over four contacts, whose impulses turn the box in opposite
  // directions.
  EXPECT_NEAR(SpeedAfterLanding(Errata::None(), 1), 2, 0.04);
  // About a hundredth of the approach speed is left, where half is correct.
  for (const int steps : {1, 2, 5, 20})
    EXPECT_LT(SpeedAfterLanding({Erratum::kE12}, steps), 0.05) << steps;
}

double TurnOfASpinningBall(const Errata& errata) {
  World world(errata, Weightless());
  Body ball = Ball(1);
  ball.w_WB = {0, 0, 1};
  world.Add(ball);
  Run(world, 1e-3, 500);
  return Eigen::AngleAxisd(world.bodies()[0].q_WB).angle();
}

TEST(PrintedWorld, TurnsSpheresButNotUnderE13) {
  EXPECT_NEAR(TurnOfASpinningBall(Errata::None()), 0.5, 1e-6);
  EXPECT_EQ(TurnOfASpinningBall({Erratum::kE13}), 0);
}

// The spin of a slab after an impulse. The slab is turned by 90° about z, which swaps its
// thin and its middle side.
Vector3d SpinAfterImpulse(const Errata& errata) {
  World world(errata, Weightless());
  Body slab = Slab();
  slab.q_WB = Eigen::AngleAxisd(std::acos(0.0), Vector3d::UnitZ());
  world.Add(slab);
  world.ApplyImpulse(0, {0, 0, 0.5}, {1, 0, 0});
  return world.bodies()[0].w_WB;
}

TEST(PrintedWorld, TurnsTheInertiaTensorButNotUnderE14) {
  // The angular impulse (0, 0.5, 0) is along the body's x axis: I = m/3 (0.5² + 1²).
  EXPECT_NEAR(SpinAfterImpulse(Errata::None()).y(), 0.5 / (2 / 3. * 1.25), kRounding);
  EXPECT_NEAR(SpinAfterImpulse({Erratum::kE14}).y(), 0.5 / (2 / 3. * 1.01), kRounding);
}

// The relative change of angular momentum after one second of free flight.
double DriftOfAngularMomentum(const Errata& errata, double dt) {
  World world(errata, Weightless());
  Body slab = Slab();
  slab.w_WB = {0.3, 5, 0.1};
  world.Add(slab);
  const Vector3d L = AngularMomentum(world.bodies()[0]);
  Run(world, dt, static_cast<int>(std::lround(1 / dt)));
  return (AngularMomentum(world.bodies()[0]) - L).norm() / L.norm();
}

TEST(PrintedWorld, KeepsAngularMomentumAsTheStepVanishesButNotUnderE15OrE16) {
  EXPECT_LT(DriftOfAngularMomentum(Errata::None(), 1e-4), 2e-3);
  EXPECT_LT(DriftOfAngularMomentum(Errata::None(), 5e-5),
            0.6 * DriftOfAngularMomentum(Errata::None(), 1e-4));
  EXPECT_GT(DriftOfAngularMomentum({Erratum::kE15}, 1e-4), 0.02);
  EXPECT_GT(DriftOfAngularMomentum({Erratum::kE16}, 1e-4), 0.02);
}

// The energy of a particle on a damped spring after one second.
double EnergyOnSpring(const Errata& errata, double damping, double dt) {
  World world(errata, Weightless());
  Particle particle;
  particle.p_W = {2, 0, 0};
  world.Add(particle);
  world.Add(Spring{{}, {Anchor::On::kParticle, 0, Vector3d::Zero()}, 40, damping, 1});
  Run(world, dt, static_cast<int>(std::lround(1 / dt)));
  const Particle& end = world.particles()[0];
  const double x = end.p_W.norm() - 1;
  return 0.5 * end.v_W.squaredNorm() + 20 * x * x;
}

TEST(PrintedWorld, DampsSpringsButNotUnderE17) {
  // ½ k x² = 20 J decays as exp(−b t / m), with a ripple of b / (2 √(k m)).
  EXPECT_NEAR(EnergyOnSpring(Errata::None(), 1, 1e-4), 20 * std::exp(-1), 0.1 * 20);
  EXPECT_GT(EnergyOnSpring({Erratum::kE17}, 1, 1e-4), 19);
}

TEST(PrintedWorld, SpringsKeepTheirEnergyWhateverTheStepButNotUnderE18) {
  EXPECT_NEAR(EnergyOnSpring(Errata::None(), 0, 1e-3), 20, 0.5);
  EXPECT_GT(EnergyOnSpring({Erratum::kE18}, 0, 1e-3), 100);
}

double ParticleSpeedAfterASecond(const Errata& errata, double dt) {
  World world(errata, Weightless());
  Particle particle;
  particle.v_W = {1, 0, 0};
  particle.damping = 2;
  world.Add(particle);
  Run(world, dt, static_cast<int>(std::lround(1 / dt)));
  return world.particles()[0].v_W.x();
}

TEST(PrintedWorld, ParticlesDecayPerSecondButPerStepUnderE19) {
  EXPECT_NEAR(ParticleSpeedAfterASecond(Errata::None(), 1e-2), std::exp(-2), kRounding);
  EXPECT_NEAR(ParticleSpeedAfterASecond({Erratum::kE19}, 1e-2), std::exp(-200 / 60.),
              kRounding);
}

TEST(PrintedWorld, AParticleIsPutAboveTheFloorAndReflected) {
  World world(Errata::None(), Weightless());
  world.Add(Floor());
  Particle particle;
  particle.p_W = {0.3, 0.05, 0};
  particle.v_W = {1, -10, 0};
  world.Add(particle);
  world.Step(0.01);
  EXPECT_NEAR(world.particles()[0].p_W.y(), 0.003, kRounding);
  EXPECT_NEAR(world.particles()[0].p_W.x(), 0.305, kRounding);
  EXPECT_TRUE(world.particles()[0].v_W.isApprox(Vector3d(1, 7, 0)));
}

TEST(PrintedWorld, AClothIsPutAtItsCentreButNotUnderE20) {
  Cloth cloth;
  cloth.n = 4;
  cloth.spacing = 0.5;
  cloth.centre = {2, 3, -4};
  const auto middle = [&](const Errata& errata) {
    World world(errata, Weightless());
    world.Add(cloth);
    Vector3d sum = Vector3d::Zero();
    for (const Particle& node : world.particles()) sum += node.p_W;
    return Vector3d(sum / 16);
  };
  EXPECT_TRUE(middle(Errata::None()).isApprox(cloth.centre));
  EXPECT_TRUE(middle({Erratum::kE20}).isApprox(Vector3d(1, 3, -2)));
}

TEST(PrintedWorld, RejectsATooSmallClothAndReportsTheFaultOfE21) {
  Cloth cloth;
  cloth.n = 2;
  World right(Errata::None(), {});
  EXPECT_THROW(right.Add(cloth), std::invalid_argument);
  World wrong({Erratum::kE21}, {});
  EXPECT_THROW(wrong.Add(cloth), std::out_of_range);
}

// The momentum of two unequal particles on a rod after one second of free flight.
Vector3d MomentumOfARod(const Errata& errata) {
  World world(errata, Weightless());
  Particle light;
  light.v_W = {0, 3, 0};
  Particle heavy;
  heavy.mass = 5;
  heavy.p_W = {1, 0, 0};
  world.Add(light);
  world.Add(heavy);
  world.Add(DistanceJoint{{Anchor::On::kParticle, 0, Vector3d::Zero()},
                          {Anchor::On::kParticle, 1, Vector3d::Zero()},
                          1});
  Run(world, 1e-3, 1000);
  const Vector3d p_01 = world.particles()[1].p_W - world.particles()[0].p_W;
  EXPECT_NEAR(p_01.norm(), 1, 1e-4);
  // The centre of mass moves by P t / m.
  return world.particles()[0].p_W + 5 * (world.particles()[1].p_W - Vector3d(1, 0, 0));
}

TEST(PrintedWorld, JointsKeepMomentumButNotUnderE22) {
  EXPECT_TRUE(MomentumOfARod(Errata::None()).isApprox(Vector3d(0, 3, 0), 1e-9));
  EXPECT_FALSE(MomentumOfARod({Erratum::kE22}).isApprox(Vector3d(0, 3, 0), 0.01));
}

// The slip of the edge of a tilted box after it hits the floor with e = 0 and enough
// friction to stick.
double SlipAfterImpact(const Errata& errata) {
  World world(errata, Weightless());
  Body box;
  box.shape = Box{{1, 0.2, 0.5}};
  box.q_WB = Eigen::AngleAxisd(0.5, Vector3d::UnitZ());
  const Vector3d edge_B(-1, -0.2, 0);
  box.p_WB = {0, -(box.q_WB * edge_B).y() - 1e-9, 0};
  box.v_WB = {1, -3, 0};
  box.restitution = 0;
  box.friction = 25;
  Body floor = Floor();
  floor.friction = 25;
  world.Add(floor);
  world.Add(box);
  world.Step(1e-9);
  const Body& end = world.bodies()[1];
  return std::abs((end.v_WB + end.w_WB.cross(end.q_WB * edge_B)).x());
}

TEST(PrintedWorld, AnImpactThatSticksLeavesNoSlipButDoesUnderE23) {
  EXPECT_LT(SlipAfterImpact(Errata::None()), 0.01);
  EXPECT_GT(SlipAfterImpact({Erratum::kE23}), 0.1);
}

// The speed of a light ball after it has slid on the floor for one second.
double SlideOfALightBall(const Errata& errata) {
  World world(errata, {});
  Body ball = Ball(1e-3);
  ball.p_WB = {0, 0.5, 0};
  ball.v_WB = {1, 0, 0};
  ball.restitution = 0;
  world.Add(Floor());
  world.Add(ball);
  Run(world, 1.0 / 240, 240);
  return world.bodies()[1].v_WB.x();
}

TEST(PrintedWorld, ALightBallIsBrakedButSlidesForEverUnderE25) {
  EXPECT_NEAR(SlideOfALightBall(Errata::None()), 5. / 7, 0.01);
  EXPECT_EQ(SlideOfALightBall({Erratum::kE25}), 1);
}

// The rotation of a tilted box whose one edge overlaps the floor.
double TurnByPositionCorrection(const Errata& errata) {
  World world(errata, Weightless());
  Body box;
  box.shape = Box{{1, 0.2, 0.5}};
  box.q_WB = Eigen::AngleAxisd(0.1, Vector3d::UnitZ());
  box.p_WB = {0, std::sin(0.1) + 0.2 * std::cos(0.1) - 0.05, 0};
  world.Add(Floor());
  world.Add(box);
  world.Step(1e-3);
  return std::abs(Eigen::AngleAxisd(world.bodies()[1].q_WB).angle() - 0.1);
}

TEST(PrintedWorld, PositionCorrectionTurnsButNotUnderE24) {
  EXPECT_GT(TurnByPositionCorrection(Errata::None()), 1e-3);
  EXPECT_LT(TurnByPositionCorrection({Erratum::kE24}), 1e-15);
}

}  // namespace
}  // namespace cookbook::printed
