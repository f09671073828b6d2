#include "reports/worlds/law_support/ball_on_plane.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "reports/worlds/law_support/round_body.h"

namespace touchstone {
namespace {

/** Largest cosine of an angle that counts as right; quaternions have 16 digits. [-] */
constexpr double kAcross = 1e-9;

}  // namespace

std::string WhyNoBallOnPlane(const World& world, int index) {
  std::string why = WhyNotOnPlane(world, index);
  if (!why.empty()) return why;
  if (!IsEvenSphere(world.bodies[static_cast<std::size_t>(index)]))
    return "is no sphere with equal moments of inertia";
  return "";
}

std::string WhyNoRollerOnPlane(const World& world, int index) {
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  if (!IsEvenRoller(body)) return WhyNoBallOnPlane(world, index);
  std::string why = WhyNotOnPlane(world, index);
  if (!why.empty()) return why;
  const OnPlane on = OnPlaneOf(world, index);
  const Eigen::Vector3d axis_W = body.placed.X_WB.R_WB.col(2);
  const auto is_across = [&](const Eigen::Vector3d& x_W) {
    return std::abs(axis_W.dot(x_W)) <= kAcross * x_W.norm();
  };
  if (!is_across(on.plane.n_W)) return "does not lie on its side";
  if (!is_across(on.along_W) || !is_across(on.v_along_W))
    return "does not move across its axis";
  if (axis_W.cross(body.w_WB).norm() > kAcross * body.w_WB.norm())
    return "does not spin about its axis";
  return "";
}

std::vector<Worst> JudgeBall(const Motion& motion, int index, const OnPlane& on,
                             const BallWords& words, const BallMotion& ball) {
  const RigidBody& body = motion.world.bodies[static_cast<std::size_t>(index)];
  const double h = motion.world.dt;
  const double r = RadiusOf(body);
  const double k = InertiaRatioOf(body);
  const double inside = on.Settling(h) / r;
  const auto predict = [&](std::size_t s) {
    const double t = motion.trajectory.times[s];
    const Eigen::Vector3d& v_WB =
        motion.trajectory.samples[s].bodies[static_cast<std::size_t>(index)].v_WB;
    const BodyState truth = ball.truth(t);
    const BallErrors errors = ball.errors(t);
    const double across = (1 + on.plane.friction) * on.SpeedAcross(v_WB, h);
    const double off = across + inside * errors.surface + errors.ending;
    const double turns = 1 / (r * std::min(1.0, k));
    return PredictedState{
        .position = {{truth.p_WB,
                      {.scheme = errors.lag + on.Settling(h) + inside * errors.speed * t,
                       .solved = errors.speed * t,
                       .computed = body.placed.X_WB.p_WB.norm()}}},
        .velocity = {{truth.v_WB, {.scheme = off, .solved = errors.speed}}},
        .spin = {{truth.w_WB, {.scheme = off * turns, .solved = errors.speed * turns}}}};
  };
  return JudgePredictions(
      motion,
      {.position = {words.position, fmt::format("{} it is at", words.how)},
       .velocity = {words.velocity, fmt::format("{} it moves at", words.how)},
       .spin = {words.velocity, fmt::format("{} it spins at", words.how)}},
      {{body.name, StateOfBody(index), predict}});
}

}  // namespace touchstone
