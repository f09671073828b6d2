#include "reports/worlds/study/untouched.h"

#include <cstddef>

#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** The share of a motion within which it is the same. */
constexpr double kSame = 0.01;

/** Whether `state` follows the fall of `start` under `a_W` after `t` [s] in steps of `h`
 [s]. */
bool Falls(const PointState& start, const PointState& state, const Eigen::Vector3d& a_W,
           double t, double h) {
  const Eigen::Vector3d v_W = start.v_W + t * a_W;
  const Eigen::Vector3d p_W = start.p_W + t * start.v_W + t * t / 2 * a_W;
  const double may_gain = a_W.norm() * h + kSame * (start.v_W.norm() + a_W.norm() * t);
  return (state.v_W - v_W).norm() <= may_gain && (state.p_W - p_W).norm() <= may_gain * t;
}

/** Whether the spin or the angular momentum is that of the start. */
bool TurnsFreely(const RigidBody& body, const BodyState& start, const BodyState& state) {
  const Eigen::Vector3d L_W = InertiaInWorld(body, start.q_WB) * start.w_WB;
  const Eigen::Vector3d now_W = InertiaInWorld(body, state.q_WB) * state.w_WB;
  return (state.w_WB - start.w_WB).norm() <= kSame * start.w_WB.norm() ||
         (now_W - L_W).norm() <= kSame * L_W.norm();
}

/** Returns whether `holds`(time, state) at each sample up to `until` [s]. */
template <typename Holds>
bool HoldsUntil(const Motion& motion, double until, const Holds& holds) {
  const Trajectory& trajectory = motion.trajectory;
  // Times are multiples of the step, to rounding.
  const double end = until + motion.world.dt / 2;
  for (std::size_t s = 0; s < trajectory.samples.size() && trajectory.times[s] <= end;
       ++s) {
    if (!holds(trajectory.times[s], trajectory.samples[s])) return false;
  }
  return true;
}

}  // namespace

bool IsUntouched(const Motion& motion, std::string_view name, double until) {
  const World& world = motion.world;
  const WorldState start = StateAtStart(world);
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const RigidBody& body = world.bodies[i];
    if (body.name != name) continue;
    if (body.mass == 0) return true;
    const BodyState& from = start.bodies[i];
    const Eigen::Vector3d a_W = AccelerationOf(world, body);
    return HoldsUntil(motion, until, [&](double t, const WorldState& state) {
      const BodyState& to = state.bodies[i];
      return Falls({from.p_WB, from.v_WB}, {to.p_WB, to.v_WB}, a_W, t, world.dt) &&
             TurnsFreely(body, from, to);
    });
  }
  for (std::size_t i = 0; i < world.particles.size(); ++i) {
    if (world.particles[i].name != name) continue;
    return HoldsUntil(motion, until, [&](double t, const WorldState& state) {
      return Falls(start.particles[i], state.particles[i], world.gravity_W, t, world.dt);
    });
  }
  return false;
}

}  // namespace touchstone
