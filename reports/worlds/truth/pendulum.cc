#include "reports/worlds/truth/pendulum.h"

#include <cmath>
#include <numbers>

#include "reports/worlds/truth/jacobi_elliptic.h"

namespace touchstone {
namespace {

/** Returns F(φ | m) for sin φ = s, cos φ >= 0. */
double EllipticF(double s, double m) {
  return s * CarlsonRF(1 - s * s, 1 - m * s * s, 1);
}

}  // namespace

Pendulum::Pendulum(double omega, const PendulumAngle& start) : omega_(omega) {
  const double s = std::sin(start.theta / 2);
  const double c = std::cos(start.theta / 2);
  const double r = start.rate / (2 * omega);
  m_ = s * s + r * r;
  m1_ = c * c - r * r;
  swings_ = m1_ >= 0;
  direction_ = start.rate < 0 ? -1 : 1;
  if (m_ == 0) return;
  if (swings_) {
    const double root = std::sqrt(m_);
    const double F = EllipticF(s / root, m_);
    // cn has the sign of the rate: it is the other half of the swing if the rate is
    // negative.
    u0_ = start.rate < 0 ? 2 * CompleteEllipticK(m1_) - F : F;
  } else {
    // ½θ is the amplitude itself, within (−π/2, π/2].
    u0_ = direction_ * EllipticF(s, 1 / m_);
  }
}

PendulumAngle Pendulum::At(double t) const {
  if (m_ == 0) return {0, 0};
  const double root = std::sqrt(m_);
  if (swings_) {
    const JacobiElliptic e = Jacobi(omega_ * t + u0_, m_, m1_);
    return {2 * std::atan2(root * e.sn, e.dn), 2 * omega_ * root * e.cn};
  }
  const JacobiElliptic e = Jacobi(root * omega_ * t + u0_, 1 / m_, -m1_ / m_);
  const double half = direction_ * std::atan2(e.sn, e.cn);
  return {std::remainder(2 * half, 2 * std::numbers::pi),
          direction_ * 2 * omega_ * root * e.dn};
}

double Pendulum::period() const {
  if (swings_) return 4 * CompleteEllipticK(m1_) / omega_;
  return 2 * CompleteEllipticK(-m1_ / m_) / (std::sqrt(m_) * omega_);
}

}  // namespace touchstone
