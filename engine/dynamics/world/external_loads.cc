#include "engine/dynamics/world/external_loads.h"

#include <algorithm>

#include "engine/dynamics/joints/spring_solver.h"

namespace cookbook {
namespace {

/** Upper bound of a speculative margin due to forces, as a fraction of the inner radius.
 */
constexpr double kMaxMarginFraction = 1.0 / 50;

/** Returns the load acceleration of a body due to gravity, forces and torques. [m/s²] */
double LoadAcceleration(const RigidBody& body, const Eigen::Vector3d& gravity_W) {
  const Eigen::Vector3d a_W = gravity_W + body.inverse_mass * body.Force_W();
  const double torque_part =
      body.is_point ? 0 : body.inverse_mass * body.Torque_W().norm() / body.radius;
  return a_W.norm() + torque_part;
}

}  // namespace

void ExternalLoads::Update(std::span<const ContactPair> pairs,
                           std::span<const DistanceJoint> joints,
                           std::span<const Spring> springs, const Settings& settings,
                           double h, std::span<RigidBody> bodies) {
  const auto at = [](int body) { return static_cast<std::size_t>(body); };
  const auto is_dynamic = [&](int body) {
    return body >= 0 && !bodies[at(body)].is_static();
  };
  joined_.Reset(bodies.size());
  const auto join = [&](int A, int B) {
    if (is_dynamic(A) && is_dynamic(B)) joined_.Unite(A, B);
  };
  for (const ContactPair& pair : pairs) {
    if (pair.manifold.count > 0) join(pair.A, pair.B);
  }
  for (const DistanceJoint& joint : joints) join(joint.A.body, joint.B.body);
  spring_forces_W_.assign(bodies.size(), Eigen::Vector3d::Zero());
  for (const Spring& spring : springs) {
    join(spring.A.body, spring.B.body);
    const Eigen::Vector3d force_W = ForceOnA(spring, bodies);
    if (spring.A.body >= 0) spring_forces_W_[at(spring.A.body)] += force_W;
    if (spring.B.body >= 0) spring_forces_W_[at(spring.B.body)] -= force_W;
  }

  const double g = settings.gravity_W.norm();
  islands_.assign(bodies.size(), {});
  for (int i = 0; i < static_cast<int>(bodies.size()); ++i) {
    RigidBody& body = bodies[at(i)];
    if (body.is_static()) continue;
    body.load_acceleration = LoadAcceleration(body, settings.gravity_W);
    if (!body.is_point) {
      body.load_acceleration = std::max(
          body.load_acceleration, body.inverse_mass * spring_forces_W_[at(i)].norm());
    }
    Island& island = islands_[at(joined_.Find(i))];
    island.mass += 1 / body.inverse_mass;
    island.excess += (body.load_acceleration - g) / body.inverse_mass;
  }

  const double gravity_margin = 2 * h * h * g;
  max_speculative_margin_ = settings.speculative_margin.value_or(gravity_margin);
  for (int i = 0; i < static_cast<int>(bodies.size()); ++i) {
    RigidBody& body = bodies[at(i)];
    // A sleeping body counts as static, but may wake in this step.
    body.island_load_acceleration = g;
    if (body.is_static()) {
      body.load_acceleration = g;
    } else {
      const Island& island = islands_[at(joined_.Find(i))];
      body.island_load_acceleration = std::max(0.0, g + island.excess / island.mass);
    }
    const double margin =
        std::min(2 * h * h * body.island_load_acceleration,
                 std::max(gravity_margin, kMaxMarginFraction * InnerRadius(body)));
    body.speculative_margin = settings.speculative_margin.value_or(margin);
    body.slop = settings.penetration_slop.value_or(margin);
    max_speculative_margin_ = std::max(max_speculative_margin_, body.speculative_margin);
  }
}

}  // namespace cookbook
