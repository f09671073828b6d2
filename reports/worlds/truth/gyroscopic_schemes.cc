#include "reports/worlds/truth/gyroscopic_schemes.h"

#include <Eigen/LU>

namespace touchstone {
namespace {

Eigen::Matrix3d Cross(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

}  // namespace

std::string_view NameOf(GyroscopicScheme scheme) {
  switch (scheme) {
    case GyroscopicScheme::kExplicit:
      return "explicit gyroscopic term";
    case GyroscopicScheme::kImplicit:
      return "implicit gyroscopic term";
    case GyroscopicScheme::kLinearlyImplicit:
      return "linearly implicit gyroscopic term";
    case GyroscopicScheme::kMomentum:
      return "spin from the kept angular momentum";
  }
  return "";
}

SteppedRotation::SteppedRotation(GyroscopicScheme scheme, const Eigen::Vector3d& inertia,
                                 const Rotation& start, double dt)
    : scheme_(scheme), inertia_(inertia), dt_(dt), state_(start) {
  L_W_ = start.q_WB * inertia.cwiseProduct(start.q_WB.conjugate() * start.w_WB);
}

Eigen::Vector3d SteppedRotation::NextSpin() const {
  // In the body frame at the start of the step, where I is diagonal.
  const Eigen::Vector3d w = state_.q_WB.conjugate() * state_.w_WB;
  const Eigen::Vector3d L = inertia_.cwiseProduct(w);
  const Eigen::Matrix3d I = inertia_.asDiagonal();
  switch (scheme_) {
    case GyroscopicScheme::kExplicit:
      return w - dt_ * w.cross(L).cwiseQuotient(inertia_);
    case GyroscopicScheme::kImplicit: {
      // Newton's method on f(ω') = I (ω' − ω) + h ω' × I ω', from ω. Each iteration
      // squares the first error, of order h²: it is below rounding after three wherever
      // the scheme is useful.
      Eigen::Vector3d next = w;
      for (int i = 0; i < 4; ++i) {
        const Eigen::Vector3d f =
            I * (next - w) + dt_ * next.cross(inertia_.cwiseProduct(next));
        const Eigen::Matrix3d df =
            I + dt_ * (Cross(next) * I - Cross(inertia_.cwiseProduct(next)));
        next -= df.inverse() * f;
      }
      return next;
    }
    case GyroscopicScheme::kLinearlyImplicit:
      return (I - dt_ * Cross(L)).inverse() * L;
    case GyroscopicScheme::kMomentum:
      break;
  }
  return w;
}

void SteppedRotation::Step() {
  state_.w_WB = state_.q_WB * NextSpin();
  const Eigen::Vector3d half = dt_ / 2 * state_.w_WB;
  const Eigen::Quaterniond turn(0, half.x(), half.y(), half.z());
  state_.q_WB.coeffs() += (turn * state_.q_WB).coeffs();
  state_.q_WB.normalize();
  if (scheme_ == GyroscopicScheme::kMomentum) {
    state_.w_WB = state_.q_WB * (state_.q_WB.conjugate() * L_W_).cwiseQuotient(inertia_);
  }
}

}  // namespace touchstone
