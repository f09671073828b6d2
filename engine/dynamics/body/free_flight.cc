#include "engine/dynamics/body/free_flight.h"

#include <algorithm>
#include <cmath>

#include "engine/dynamics/body/rotation.h"

namespace cookbook {
namespace {

/** Translates `body`, which is `flight.start`, by `time` [s]. Does not rotate it. */
void Move(const FreeFlight& flight, double time, RigidBody& body) {
  const BodyState& start = flight.start.state;
  body.state.p_WB += time * (start.v_WB + 0.5 * time * flight.a_W);
  body.state.v_WB += time * flight.a_W;
}

}  // namespace

RigidBody FreeFlight::ShapeAt(double t, Gyroscopic rule) const {
  if (!start.is_sphere) return At(t, rule);
  RigidBody body = start;
  if (!body.is_static()) Move(*this, std::min(t, until) - from, body);
  return body;
}

RigidBody FreeFlight::At(double t, Gyroscopic rule) const {
  RigidBody body = start;
  const double time = std::min(t, until) - from;
  if (body.is_static() || time == 0) return body;
  Move(*this, time, body);
  const Eigen::Vector3d& w = start.state.w_WB;
  if (rule == Gyroscopic::kExact) {
    const Eigen::Vector3d L_W = WorldInertiaTimes(start.R_WB, start.moments, w);
    const AngularState end = IntegrateAngularMomentum(
        {start.state.q_WB, w}, start.moments, L_W, {time * torque_W, {}}, time);
    body.state.q_WB = end.q_WB;
    body.state.w_WB = end.w_WB;
  } else {
    body.state.w_WB +=
        WorldInertiaTimes(start.R_WB, start.inverse_moments, time * torque_W) +
        GyroscopicChange(start.R_WB, start.moments, w, time, rule);
    body.state.q_WB =
        (Exp(0.5 * time * (w + body.state.w_WB)) * start.state.q_WB).normalized();
  }
  body.R_WB = body.state.q_WB.toRotationMatrix();
  return body;
}

double RotationalSpeed(const RigidBody& body) {
  return body.is_sphere ? 0 : body.radius * body.state.w_WB.norm();
}

double RotationalSpeed(const RigidBody& body, const Eigen::Vector3d& n_W) {
  return body.is_sphere ? 0 : body.radius * n_W.cross(body.state.w_WB).norm();
}

double MaxTravelByRotation(const RigidBody& body, double time) {
  return body.is_static() ? 0 : std::min(2 * body.radius, time * RotationalSpeed(body));
}

double MaxTravel(const RigidBody& body, const Eigen::Vector3d& v_W, double time) {
  if (body.is_static()) return 0;
  return time * std::sqrt(std::max(body.state.v_WB.squaredNorm(), v_W.squaredNorm())) +
         MaxTravelByRotation(body, time);
}

}  // namespace cookbook
