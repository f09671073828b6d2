#include "engine/dynamics/body/rotation.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace cookbook {

bool IsRound(const Eigen::Vector3d& moments) {
  return moments[0] == moments[1] && moments[1] == moments[2];
}

Eigen::Quaterniond Exp(const Eigen::Vector3d& phi) {
  const double squared = phi.squaredNorm();
  // sin(θ/2)/θ and cos(θ/2) by their series in θ²: the next terms, θ⁸/(2⁹ 9!) and
  // θ¹⁰/(2¹⁰ 10!), are under rounding.
  if (squared < kSmallTurnSquared) {
    const double s =
        0.5 + squared * (-1.0 / 48 + squared * (1.0 / 3840 - squared / 645120));
    const double c =
        1 + squared * (-1.0 / 8 + squared * (1.0 / 384 + squared * (-1.0 / 46080 +
                                                                    squared / 10321920)));
    return {c, s * phi[0], s * phi[1], s * phi[2]};
  }
  const double angle = std::sqrt(squared);
  const double s = std::sin(angle / 2) / angle;
  return {std::cos(angle / 2), s * phi[0], s * phi[1], s * phi[2]};
}

Eigen::Vector3d TurnedInertiaTimes(const Eigen::Matrix3d& R_WB,
                                   const Eigen::Vector3d& moments,
                                   const Eigen::Vector3d& u_W) {
  if (IsRound(moments)) return moments[0] * u_W;
  const Eigen::Vector3d u_B = R_WB.transpose() * u_W;
  return R_WB * moments.cwiseProduct(u_B);
}

namespace {

/** A step is taken in parts where it makes or loses more than this share of the energy: a
 thin rod that turns by half a radian makes all of it again. A box of 1 : 4 : 9 that turns
 by a twelfth of a radian makes 1e-8, and goes on in whole steps. */
constexpr double kEnergyOff = 1e-6;

/** Parts beyond which a step is left as it is: a needle of 1 : 70 that turns by sixteen
 radians takes half as many. */
constexpr int kMostParts = 256;

/** A part of a step. */
struct Part {
  Turning end;
  double energy;  ///< The greater of those at both ends, times 2 h. [J s]
  double off;     ///< By how much energy and work differ, times 2 h. [J s]
};

Part Turn(const Eigen::Quaterniond& q, const Eigen::Vector3d& inverse,
          const Eigen::Vector3d& L_W, const Eigen::Vector3d& dL_W, double h) {
  const Eigen::Vector3d L_mid = L_W + 0.5 * dL_W;
  const Eigen::Vector3d L_end = L_W + dL_W;
  // q = exp(u) q₀ with u̇ = ω − u × ω / 2 + …, solved by the classical Runge–Kutta scheme
  // with the two commutators that keep it of fourth order (Munthe-Kaas 1998).
  const auto omega = [&](const Eigen::Quaterniond& at,
                         const Eigen::Vector3d& L) -> Eigen::Vector3d {
    return TurnedInertiaTimes(at.toRotationMatrix(), inverse, L);
  };
  const Eigen::Vector3d k1 = h * omega(q, L_W);
  const Eigen::Vector3d k2 = h * omega(Exp(0.5 * k1) * q, L_mid);
  const Eigen::Vector3d k3 = h * omega(Exp(0.5 * k2 - 0.125 * k1.cross(k2)) * q, L_mid);
  const Eigen::Vector3d k4 = h * omega(Exp(k3) * q, L_end);
  Part part;
  part.end.q_WB = Exp((k1 + 2 * (k2 + k3) + k4 - 0.5 * k1.cross(k4)) / 6) * q;
  part.end.q_WB.normalize();
  part.end.w_WB = omega(part.end.q_WB, L_end);
  // E = L·ω/2, and the work is the integral of L̇·ω.
  const double before = L_W.dot(k1);
  const double after = h * L_end.dot(part.end.w_WB);
  const double work = dL_W.dot(k1 + 2 * (k2 + k3) + k4) / 3;
  part.energy = std::max(std::abs(before), std::abs(after));
  part.off = std::abs(after - before - work);
  return part;
}

}  // namespace

Eigen::Quaterniond Turned(const Eigen::Quaterniond& q_WB, const Eigen::Vector3d& from_W,
                          const Eigen::Vector3d& to_W, double h) {
  // The Magnus expansion.
  const Eigen::Vector3d k1 = h * from_W;
  const Eigen::Vector3d k4 = h * to_W;
  Eigen::Quaterniond q = Exp(0.5 * (k1 + k4) - k1.cross(k4) / 12) * q_WB;
  q.normalize();
  return q;
}

Turning TurnWithMomentum(const Turning& start, const Eigen::Vector3d& moments,
                         const Eigen::Vector3d& L_W, const Eigen::Vector3d& dL_W,
                         double h) {
  Turning end;
  if (IsRound(moments)) {
    // ω is parallel to L whatever q is.
    end.w_WB = start.w_WB + dL_W / moments[0];
    end.q_WB = Turned(start.q_WB, start.w_WB, end.w_WB, h);
    return end;
  }
  const Eigen::Vector3d inverse = moments.cwiseInverse();
  for (int parts = 1;; parts *= 2) {
    const double share = 1.0 / parts;
    const Eigen::Vector3d dL_part_W = share * dL_W;
    end = start;
    double off = 0;
    double energy = 0;
    const bool is_last = parts == kMostParts;
    for (int k = 0; k < parts && (is_last || !(off > kEnergyOff * energy)); ++k) {
      const Part part =
          Turn(end.q_WB, inverse, L_W + k * dL_part_W, dL_part_W, share * h);
      end = part.end;
      off += part.off;
      energy = std::max(energy, part.energy);
    }
    if (is_last || !(off > kEnergyOff * energy)) return end;
  }
}

Eigen::Vector3d GyroscopicChange(const Eigen::Matrix3d& R_WB,
                                 const Eigen::Vector3d& moments,
                                 const Eigen::Vector3d& w_WB, double h, Gyroscopic rule) {
  if (rule == Gyroscopic::kOff || IsRound(moments)) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d w_B = R_WB.transpose() * w_WB;
  const Eigen::Vector3d L_B = moments.cwiseProduct(w_B);
  const Eigen::Vector3d torque_B = -w_B.cross(L_B);
  if (rule != Gyroscopic::kImplicit) {
    return R_WB * (h * torque_B.cwiseQuotient(moments)).eval();
  }
  // f(ω) = I (ω − ω₀) + h ω × I ω; one Newton step from ω₀ with its Jacobian
  // I + h ([ω]× I − [I ω]×).
  const auto cross = [](const Eigen::Vector3d& u) {
    Eigen::Matrix3d m;
    m << 0, -u[2], u[1], u[2], 0, -u[0], -u[1], u[0], 0;
    return m;
  };
  const Eigen::Matrix3d inertia = moments.asDiagonal();
  const Eigen::Matrix3d jacobian = inertia + h * (cross(w_B) * inertia - cross(L_B));
  const Eigen::Vector3d dw_B = jacobian.inverse() * (h * torque_B);
  return R_WB * dw_B;
}

}  // namespace cookbook
