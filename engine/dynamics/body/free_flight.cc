#include "engine/dynamics/body/free_flight.h"

#include <algorithm>
#include <cmath>

#include "engine/dynamics/body/rotation.h"

namespace cookbook {

namespace {

/** Moves `body`, which is that of `flight` when it starts, but does not turn it. */
void Move(const FreeFlight& flight, double time, RigidBody& body) {
  const BodyState& start = flight.start.state;
  body.state.p_WB += time * (start.v_WB + 0.5 * time * flight.a_W);
  body.state.v_WB += time * flight.a_W;
}

}  // namespace

RigidBody FreeFlight::RoomAt(double t, Gyroscopic rule) const {
  if (!start.is_ball) return At(t, rule);
  RigidBody body = start;
  if (!body.is_static()) Move(*this, t - from, body);
  return body;
}

RigidBody FreeFlight::At(double t, Gyroscopic rule) const {
  RigidBody body = start;
  if (body.is_static() || t == from) return body;
  const double time = t - from;
  Move(*this, time, body);
  const Eigen::Vector3d& w = start.state.w_WB;
  if (rule == Gyroscopic::kExact) {
    const Eigen::Vector3d L_W = TurnedInertiaTimes(start.R_WB, start.moments, w);
    const Turning end = TurnWithMomentum({start.state.q_WB, w}, start.moments, L_W,
                                         time * torque_W, time);
    body.state.q_WB = end.q_WB;
    body.state.w_WB = end.w_WB;
  } else {
    body.state.w_WB +=
        TurnedInertiaTimes(start.R_WB, start.inverse_moments, time * torque_W) +
        GyroscopicChange(start.R_WB, start.moments, w, time, rule);
    body.state.q_WB =
        (Exp(0.5 * time * (w + body.state.w_WB)) * start.state.q_WB).normalized();
  }
  body.R_WB = body.state.q_WB.toRotationMatrix();
  return body;
}

double TurningSpeed(const RigidBody& body) {
  return body.is_ball ? 0 : body.radius * body.state.w_WB.norm();
}

double TurningSpeed(const RigidBody& body, const Eigen::Vector3d& n_W) {
  return body.is_ball ? 0 : body.radius * n_W.cross(body.state.w_WB).norm();
}

double Reach(const RigidBody& body, const Eigen::Vector3d& v_W, double time) {
  if (body.is_static()) return 0;
  return time * std::sqrt(std::max(body.state.v_WB.squaredNorm(), v_W.squaredNorm())) +
         std::min(2 * body.radius, time * TurningSpeed(body));
}

}  // namespace cookbook
