#include "tests/acceptance/published_worlds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace touchstone {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Measured = std::map<std::string, double>;

constexpr double kGravity = 9.81;  // [m/s²]

double Radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

World Empty(double dt, double duration) {
  World world;
  world.gravity_W = {0, 0, -kGravity};
  world.dt = dt;
  world.steps = static_cast<int>(std::lround(duration / dt));
  return world;
}

RigidBody Add(World& world, const Shape& shape, const Vector3d& p_W, double mass,
              double restitution, double friction) {
  RigidBody body;
  body.name = fmt::format("body_{}", world.bodies.size());
  body.placed = {shape, Pose::FromQuaternion(p_W, Quaterniond::Identity())};
  body.mass = mass;
  body.restitution = restitution;
  body.friction = friction;
  world.bodies.push_back(body);
  return body;
}

/* Adds a static box whose top is z = 0. */
void AddGround(World& world, double restitution, double friction) {
  Add(world, Box{{50, 50, 0.5}}, {0, 0, -0.5}, 0, restitution, friction);
}

/* Simulates `world`. Calls `see` with the time and the state at the start and after every
 step. Returns the last state. */
WorldState Simulate(const Oracle& oracle, const World& world,
                    const std::function<void(double, const WorldState&)>& see) {
  const std::unique_ptr<Simulation> simulation = oracle.Begin(world);
  WorldState state;
  simulation->Read(state);
  see(0, state);
  for (int step = 1; step <= world.steps; ++step) {
    simulation->Step();
    simulation->Read(state);
    see(step * world.dt, state);
  }
  return state;
}

WorldState SimulateToEnd(const Oracle& oracle, const World& world) {
  return Simulate(oracle, world, [](double, const WorldState&) {});
}

/* The benchmark has 49 balls that never collide with each other, so one is simulated. The
 score is the mean of (E − E₀)² over the states before each step. */
Measured Bouncing(const Oracle& oracle, double dt) {
  World world = Empty(dt, 20);
  AddGround(world, 1, 0);
  const double mass = 10;
  Add(world, Sphere{0.1}, {0, 0, 5}, mass, 1, 0);
  const double E_0 = 49 * mass * kGravity * 5;
  double sum = 0;
  double last = 0;  // Value after the last step, which is not counted.
  Simulate(oracle, world, [&](double, const WorldState& state) {
    const BodyState& ball = state.bodies[1];
    const double E = 49 * mass * (kGravity * ball.p_WB.z() + ball.v_WB.squaredNorm() / 2);
    last = (E - E_0) * (E - E_0);
    sum += last;
  });
  return {{"score", (sum - last) / world.steps}};
}

/* The score is the mean, over the states before each step, of the squared errors of the
 velocities of the plate and of the first ball. */
Measured Rolling(const Oracle& oracle, double dt, double degrees) {
  constexpr double kPenetration = 2e-5;  // [m] Depth of each contact at the start.
  constexpr double kForce = 150;         // [N]
  constexpr double kPlate = 10;          // [kg]
  constexpr double kBall = 1;            // [kg]
  constexpr int kBalls = 25;
  World world = Empty(dt, 4);
  // Friction is sqrt(0.2 · 0.8) = 0.4 under the plate, and 0.8 on it.
  AddGround(world, 0, 0.2);
  Add(world, Box{{10, 10, 0.5}}, {0, 0, 0.5 - kPenetration}, kPlate, 0, 0.8);
  const Vector3d direction(std::cos(Radians(degrees)), std::sin(Radians(degrees)), 0);
  world.bodies.back().force_W = kForce * direction;
  for (int i = 0; i < kBalls; ++i) {
    const Vector3d p_W(2.0 * (i % 5) - 4, 2.0 * (i / 5) - 4, 1.5 - 3 * kPenetration);
    Add(world, Sphere{0.5}, p_W, kBall, 0, 0.8);
  }
  // The plate slides on the ground, and all balls roll on the plate.
  const double under = 0.4 * (kPlate + kBalls * kBall) * kGravity;
  const double of_ball = (kForce - under) / kPlate / (3.5 / kBall + kBalls / kPlate);
  const double of_plate = (kForce - under - kBalls * of_ball) / kPlate;
  double sum = 0;
  double last = 0;
  Simulate(oracle, world, [&](double t, const WorldState& state) {
    last = (state.bodies[1].v_WB - of_plate * t * direction).squaredNorm() +
           (state.bodies[2].v_WB - of_ball / kBall * t * direction).squaredNorm();
    sum += last;
  });
  return {{"score", (sum - last) / world.steps}};
}

/* Returns the largest errors after any step. */
Measured Boxes(const Oracle& oracle, double dt, bool is_complex) {
  World world = Empty(dt, 10);
  Add(world, Box{{0.05, 0.2, 0.45}}, Vector3d::Zero(), 10, 0, 0);
  RigidBody& box = world.bodies[0];
  if (is_complex) {
    world.gravity_W = {0, 0, -9.8};
    box.v_WB = {-2, 2, 8};
    box.w_WB = {0.1, 5, 0.1};
  } else {
    world.gravity_W.setZero();
    box.v_WB = {-0.9, 0.4, 0.1};
    box.w_WB = {0.5, 0, 0};
  }
  const Vector3d I = InertiaOf(box);
  const Vector3d L_0 = I.cwiseProduct(box.w_WB);
  const double E_0 = box.mass * box.v_WB.squaredNorm() / 2 + box.w_WB.dot(L_0) / 2;
  Measured worst = {
      {"energy", 0}, {"angular momentum", 0}, {"position", 0}, {"angle", 0}};
  const auto take = [&](const char* name, double error) {
    worst[name] = std::max(worst[name], error);
  };
  Simulate(oracle, world, [&](double t, const WorldState& state) {
    const BodyState& body = state.bodies[0];
    const Vector3d w_B = body.q_WB.conjugate() * body.w_WB;
    const double E = box.mass * body.v_WB.squaredNorm() / 2 +
                     w_B.dot(I.cwiseProduct(w_B)) / 2 -
                     box.mass * world.gravity_W.dot(body.p_WB);
    take("energy", std::abs(E - E_0) / E_0);
    const Vector3d L = body.q_WB * I.cwiseProduct(w_B);
    take("angular momentum", (L - L_0).norm() / L_0.norm());
    const Vector3d p_W = t * box.v_WB + t * t / 2 * world.gravity_W;
    take("position", (body.p_WB - p_W).norm());
    const Quaterniond q(Eigen::AngleAxisd(0.5 * t, Vector3d::UnitX()));
    if (!is_complex) take("angle", 2 * (q.conjugate() * body.q_WB).vec().norm());
  });
  return worst;
}

Measured Drop(const Oracle& oracle, double dt) {
  World world = Empty(dt, 2);
  AddGround(world, 0, 0.5);
  Add(world, Sphere{0.5}, {0, 0, 1.5}, 1, 0, 0.5);
  return {{"gap", SimulateToEnd(oracle, world).bodies[1].p_WB.z() - 0.5}};
}

Measured Slide(const Oracle& oracle, double dt, double degrees) {
  World world = Empty(dt, 2);
  AddGround(world, 0, 0.5);
  Add(world, Box{{0.5, 0.5, 0.05}}, {0, 0, 0.05 - 1e-7}, 1, 0, 0.5);
  world.bodies[1].v_WB =
      5 * Vector3d(std::cos(Radians(degrees)), std::sin(Radians(degrees)), 0);
  const Vector3d p_W = SimulateToEnd(oracle, world).bodies[1].p_WB;
  return {{"x", p_W.x()}, {"y", p_W.y()}};
}

Measured SlipAndRoll(const Oracle& oracle, double dt) {
  World world = Empty(dt, 2);
  AddGround(world, 0, 0.3);
  Add(world, Sphere{0.5}, {0, 0, 0.5 - 1e-7}, 1, 0, 0.3);
  world.bodies[1].v_WB = {5, 0, 0};
  const BodyState ball = SimulateToEnd(oracle, world).bodies[1];
  return {{"x", ball.p_WB.x()}, {"v", ball.v_WB.x()}, {"wR", ball.w_WB.y() * 0.5}};
}

Measured Cradle(const Oracle& oracle, double dt) {
  World world = Empty(dt, 0.2);
  world.gravity_W.setZero();
  // The first ball starts 0.1 m away from the second. The others overlap by 1e-9 m.
  for (int i = 0; i < 5; ++i)
    Add(world, Sphere{0.5}, {i == 0 ? -0.1 : i * (1 - 1e-9), 0, 0}, 1, 1, 0);
  world.bodies[0].v_WB = {1, 0, 0};
  const WorldState end = SimulateToEnd(oracle, world);
  return {{"v first", end.bodies[0].v_WB.x()}, {"v last", end.bodies[4].v_WB.x()}};
}

}  // namespace

std::map<std::string, double> RunPublished(std::string_view benchmark,
                                           const Oracle& oracle, double dt) {
  if (benchmark == "bouncing") return Bouncing(oracle, dt);
  if (benchmark == "rolling 60 deg") return Rolling(oracle, dt, 60);
  if (benchmark == "rolling 90 deg") return Rolling(oracle, dt, 90);
  if (benchmark == "boxes simple") return Boxes(oracle, dt, false);
  if (benchmark == "boxes complex") return Boxes(oracle, dt, true);
  if (benchmark == "drop") return Drop(oracle, dt);
  if (benchmark == "slide 30 deg") return Slide(oracle, dt, 30);
  if (benchmark == "slip and roll") return SlipAndRoll(oracle, dt);
  if (benchmark == "cradle") return Cradle(oracle, dt);
  throw std::invalid_argument(fmt::format("no benchmark is named \"{}\"", benchmark));
}

}  // namespace touchstone
