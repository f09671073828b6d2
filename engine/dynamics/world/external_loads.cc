#include "engine/dynamics/world/external_loads.h"

#include <algorithm>

namespace cookbook {
namespace {

/** Share of the inner radius up to which what forces make is a margin. */
constexpr double kOfBall = 1.0 / 50;

/** Returns what gravity, forces and torques make of a body. [m/s²] */
double LoadOf(const RigidBody& body, const Eigen::Vector3d& gravity_W) {
  const Eigen::Vector3d a_W = gravity_W + body.inverse_mass * body.Force_W();
  const double turning =
      body.is_point ? 0 : body.inverse_mass * body.Torque_W().norm() / body.radius;
  return a_W.norm() + turning;
}

}  // namespace

void ExternalLoads::Find(std::span<const ContactPair> contacts,
                         std::span<const DistanceJoint> joints,
                         std::span<const Spring> springs, const Settings& settings,
                         double h, std::span<RigidBody> bodies) {
  const auto at = [](int body) { return static_cast<std::size_t>(body); };
  const auto moves = [&](int body) { return body >= 0 && !bodies[at(body)].is_static(); };
  joined_.Reset(bodies.size());
  const auto join = [&](int A, int B) {
    if (moves(A) && moves(B)) joined_.Unite(A, B);
  };
  for (const ContactPair& pair : contacts) {
    if (pair.manifold.count > 0) join(pair.A, pair.B);
  }
  for (const DistanceJoint& joint : joints) join(joint.A.body, joint.B.body);
  spring_forces_W_.assign(bodies.size(), Eigen::Vector3d::Zero());
  for (const Spring& spring : springs) {
    join(spring.A.body, spring.B.body);
    const Eigen::Vector3d load_W = ForceOnA(spring, bodies);
    if (spring.A.body >= 0) spring_forces_W_[at(spring.A.body)] += load_W;
    if (spring.B.body >= 0) spring_forces_W_[at(spring.B.body)] -= load_W;
  }

  const double g = settings.gravity_W.norm();
  islands_.assign(bodies.size(), {});
  for (int i = 0; i < static_cast<int>(bodies.size()); ++i) {
    RigidBody& body = bodies[at(i)];
    if (body.is_static()) continue;
    body.load = LoadOf(body, settings.gravity_W);
    if (!body.is_point) {
      body.load = std::max(body.load, body.inverse_mass * spring_forces_W_[at(i)].norm());
    }
    Island& island = islands_[at(joined_.Find(i))];
    island.mass += 1 / body.inverse_mass;
    island.excess += (body.load - g) / body.inverse_mass;
  }

  const double of_gravity = 2 * h * h * g;
  greatest_margin_ = settings.speculative_margin.value_or(of_gravity);
  for (int i = 0; i < static_cast<int>(bodies.size()); ++i) {
    RigidBody& body = bodies[at(i)];
    // What sleeps may wake in this step.
    body.island_load = g;
    if (body.is_static()) {
      body.load = g;
    } else {
      const Island& island = islands_[at(joined_.Find(i))];
      body.island_load = std::max(0.0, g + island.excess / island.mass);
    }
    const double of_two_steps = std::min(
        2 * h * h * body.island_load, std::max(of_gravity, kOfBall * InnerRadius(body)));
    body.speculative_margin = settings.speculative_margin.value_or(of_two_steps);
    body.slop = settings.penetration_slop.value_or(of_two_steps);
    greatest_margin_ = std::max(greatest_margin_, body.speculative_margin);
  }
}

}  // namespace cookbook
