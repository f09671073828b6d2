#include "reports/worlds/truth/torque_free_rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "reports/worlds/truth/jacobi_elliptic.h"

namespace touchstone {
namespace {

/** Nodes and weights of Gauss-Legendre quadrature with 10 points on [−1, 1] (Abramowitz &
 Stegun, table 25.4); the other half is the mirror image. */
constexpr std::array<std::array<double, 2>, 5> kGauss = {{
    {0.148874338981631211, 0.295524224714752870},
    {0.433395394129247191, 0.269266719309996355},
    {0.679409568299024406, 0.219086362515982044},
    {0.865063366688984511, 0.149451349150580593},
    {0.973906528517171720, 0.066671344308688138},
}};

/** Returns the rotation by the rotation vector `angle` [rad]. */
Eigen::Quaterniond Turn(const Eigen::Vector3d& angle) {
  const double size = angle.norm();
  if (size == 0) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(size, angle / size));
}

/** Returns a body frame whose last column is the direction of L and whose first column
 leans towards axis a: it follows L as L moves through the body. */
Eigen::Matrix3d FrameOf(const Eigen::Vector3d& L_B, int a) {
  Eigen::Matrix3d frame;
  frame.col(2) = L_B.normalized();
  const Eigen::Vector3d axis = Eigen::Vector3d::Unit(a);
  frame.col(1) = frame.col(2).cross(axis).normalized();
  frame.col(0) = frame.col(1).cross(frame.col(2));
  return frame;
}

}  // namespace

TorqueFreeRotation::TorqueFreeRotation(const Eigen::Vector3d& inertia,
                                       const Rotation& start)
    : inertia_(inertia), start_(start) {
  const Eigen::Vector3d w = start.q_WB.conjugate() * start.w_WB;
  const Eigen::Vector3d L = inertia.cwiseProduct(w);
  L_W_ = start.q_WB * L;
  energy_ = w.dot(L) / 2;
  // A torque w × L below a rounding of its terms comes from the digits of the file.
  steady_ = w.cross(L).norm() <=
            4 * std::numeric_limits<double>::epsilon() * w.norm() * L.norm();
  if (steady_) return;

  std::array<int, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return inertia[i] > inertia[j]; });
  // L² − 2T I_b as a sum of differences, which loses no digits near the separatrix.
  const auto above = [&](int of) {
    double sum = 0;
    for (int i = 0; i < 3; ++i)
      sum += inertia[i] * (inertia[i] - inertia[of]) * w[i] * w[i];
    return sum;
  };
  b_ = order[1];
  const bool about_largest = above(b_) > 0;
  a_ = about_largest ? order[0] : order[2];
  c_ = about_largest ? order[2] : order[0];
  const double Ia = inertia[a_];
  const double Ib = inertia[b_];
  const double Ic = inertia[c_];
  const double from_a = above(a_);  // L² − 2T I_a
  const double from_b = above(b_);
  const double from_c = above(c_);
  A_ = std::copysign(std::sqrt(from_c / (Ia * (Ia - Ic))), w[a_]);
  C_ = std::copysign(std::sqrt(-from_a / (Ic * (Ia - Ic))), w[c_]);
  const double size_of_B = std::sqrt(-from_a / (Ib * (Ia - Ib)));
  lambda_ = std::sqrt((Ia - Ib) * from_c / (Ia * Ib * Ic));
  m_ = std::clamp((Ib - Ic) * -from_a / ((Ia - Ib) * from_c), 0.0, 1.0);
  m1_ = std::clamp((Ia - Ic) * from_b / ((Ia - Ib) * from_c), 0.0, 1.0);
  // I_b ω̇_b = ±(I_c − I_a) ω_c ω_a gives B λ I_b = ±(I_c − I_a) A C, + for a, b, c
  // cyclic.
  const double cyclic = (a_ + 1) % 3 == b_ ? 1 : -1;
  B_ = std::copysign(size_of_B, cyclic * (Ic - Ia) * A_ * C_);

  // C has the sign of ω_c, so that u₀ lies in [−K, K].
  double sn = w[b_] / B_;
  double cn = w[c_] / C_;
  const double norm = std::hypot(sn, cn);
  sn /= norm;
  cn /= norm;
  u0_ = sn * CarlsonRF(cn * cn, m1_ + m_ * cn * cn, 1);
}

Eigen::Vector3d TorqueFreeRotation::SpinInBody(double t) const {
  if (steady_) return start_.q_WB.conjugate() * start_.w_WB;
  const JacobiElliptic at = Jacobi(u0_ + lambda_ * t, m_, m1_);
  Eigen::Vector3d w;
  w[a_] = A_ * at.dn;
  w[b_] = B_ * at.sn;
  w[c_] = C_ * at.cn;
  return w;
}

double TorqueFreeRotation::PrecessionRate(double t) const {
  const Eigen::Vector3d w = SpinInBody(t);
  const Eigen::Vector3d L = inertia_.cwiseProduct(w);
  return L.norm() * (w[b_] * L[b_] + w[c_] * L[c_]) / (L[b_] * L[b_] + L[c_] * L[c_]);
}

double TorqueFreeRotation::Precession(double from, double to) const {
  // The integrand has two kinds of nearest poles in u. Those of the elliptic functions
  // are K' >= π/2 away from the real axis. Those where L_b² + L_c² = 0, at dn u =
  // |L|/(I_a A), are about √(I_c (I_a−I_b)/(I_a (I_b−I_c))) away. On panels half as wide,
  // ten points leave 1e-17.
  const double pole = std::sqrt(std::abs(inertia_[c_] * (inertia_[a_] - inertia_[b_]) /
                                         (inertia_[a_] * (inertia_[b_] - inertia_[c_]))));
  const double width = std::min(1.0, pole) / 2;
  const int panels =
      std::max(1, static_cast<int>(std::ceil((to - from) * lambda_ / width)));
  const double half = (to - from) / (2.0 * panels);
  double sum = 0;
  for (int i = 0; i < panels; ++i) {
    const double middle = from + (2 * i + 1) * half;
    for (const auto& [node, weight] : kGauss) {
      sum += weight * (PrecessionRate(middle - node * half) +
                       PrecessionRate(middle + node * half));
    }
  }
  return sum * half;
}

std::vector<Rotation> TorqueFreeRotation::At(std::span<const double> times) const {
  std::vector<Rotation> rotations;
  rotations.reserve(times.size());
  if (steady_) {
    for (const double t : times)
      rotations.push_back({Turn(start_.w_WB * t) * start_.q_WB, start_.w_WB});
    return rotations;
  }
  const Eigen::Vector3d axis = L_W_.normalized();
  const Eigen::Matrix3d frame_at_start =
      start_.q_WB.toRotationMatrix() * FrameOf(inertia_.cwiseProduct(SpinInBody(0)), a_);
  double last = 0;
  double angle = 0;
  for (const double t : times) {
    angle += Precession(last, t);
    last = t;
    const Eigen::Vector3d w_B = SpinInBody(t);
    const Eigen::Matrix3d R_WB = Eigen::AngleAxisd(angle, axis) * frame_at_start *
                                 FrameOf(inertia_.cwiseProduct(w_B), a_).transpose();
    rotations.push_back({Eigen::Quaterniond(R_WB), R_WB * w_B});
  }
  return rotations;
}

double TorqueFreeRotation::period() const {
  return steady_ ? std::numeric_limits<double>::infinity()
                 : 4 * CompleteEllipticK(m1_) / lambda_;
}

}  // namespace touchstone
