#include "engine/dynamics/body/rotation.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace cookbook {

bool IsIsotropic(const Eigen::Vector3d& moments) {
  return moments[0] == moments[1] && moments[1] == moments[2];
}

Eigen::Quaterniond Exp(const Eigen::Vector3d& phi) {
  const double squared = phi.squaredNorm();
  // sin(θ/2)/θ and cos(θ/2) by their series in θ²: the next terms, θ⁸/(2⁹ 9!) and
  // θ¹⁰/(2¹⁰ 10!), are below rounding.
  if (squared < kSmallAngleSquared) {
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

Eigen::Vector3d WorldInertiaTimes(const Eigen::Matrix3d& R_WB,
                                  const Eigen::Vector3d& moments,
                                  const Eigen::Vector3d& u_W) {
  if (IsIsotropic(moments)) return moments[0] * u_W;
  const Eigen::Vector3d u_B = R_WB.transpose() * u_W;
  return R_WB * moments.cwiseProduct(u_B);
}

namespace {

/** Relative energy error beyond which a step is divided into sub-steps. A thin rod that
 turns by half a radian in one step doubles its energy. A box of 1 : 4 : 9 that turns by a
 twelfth of a radian has an error of 1e-8, and needs no sub-steps. */
constexpr double kEnergyTolerance = 1e-6;

/** Maximum number of sub-steps. A needle of 1 : 70 that turns by sixteen radians needs
 half as many. */
constexpr int kMaxSubSteps = 256;

/** The result of a sub-step. */
struct SubStep {
  AngularState end;
  double energy;  ///< Greater kinetic energy of start and end, times 2 h. [J s]
  double error;   ///< Difference between change of energy and work, times 2 h. [J s]
};

SubStep TakeSubStep(const Eigen::Quaterniond& q, const Eigen::Vector3d& inverse,
                    const Eigen::Vector3d& L_W, const Eigen::Vector3d& dL_W, double h) {
  const Eigen::Vector3d L_mid = L_W + 0.5 * dL_W;
  const Eigen::Vector3d L_end = L_W + dL_W;
  // q = exp(u) q₀ with u̇ = ω − u × ω / 2 + …, integrated by the classical Runge–Kutta
  // scheme with the two commutators that make it fourth order (Munthe-Kaas 1998).
  const auto omega = [&](const Eigen::Quaterniond& at,
                         const Eigen::Vector3d& L) -> Eigen::Vector3d {
    return WorldInertiaTimes(at.toRotationMatrix(), inverse, L);
  };
  const Eigen::Vector3d k1 = h * omega(q, L_W);
  const Eigen::Vector3d k2 = h * omega(Exp(0.5 * k1) * q, L_mid);
  const Eigen::Vector3d k3 = h * omega(Exp(0.5 * k2 - 0.125 * k1.cross(k2)) * q, L_mid);
  const Eigen::Vector3d k4 = h * omega(Exp(k3) * q, L_end);
  SubStep step;
  step.end.q_WB = Exp((k1 + 2 * (k2 + k3) + k4 - 0.5 * k1.cross(k4)) / 6) * q;
  step.end.q_WB.normalize();
  step.end.w_WB = omega(step.end.q_WB, L_end);
  // E = L·ω/2, and the work is the integral of L̇·ω.
  const double before = L_W.dot(k1);
  const double after = h * L_end.dot(step.end.w_WB);
  const double work = dL_W.dot(k1 + 2 * (k2 + k3) + k4) / 3;
  step.energy = std::max(std::abs(before), std::abs(after));
  step.error = std::abs(after - before - work);
  return step;
}

}  // namespace

Eigen::Quaterniond IntegrateRotation(const Eigen::Quaterniond& q_WB,
                                     const Eigen::Vector3d& from_W,
                                     const Eigen::Vector3d& to_W, double h) {
  // The Magnus expansion to fourth order.
  const Eigen::Vector3d k1 = h * from_W;
  const Eigen::Vector3d k4 = h * to_W;
  Eigen::Quaterniond q = Exp(0.5 * (k1 + k4) - k1.cross(k4) / 12) * q_WB;
  q.normalize();
  return q;
}

AngularState IntegrateAngularMomentum(const AngularState& start,
                                      const Eigen::Vector3d& moments,
                                      const Eigen::Vector3d& L_W,
                                      const Eigen::Vector3d& dL_W, double h) {
  AngularState end;
  if (IsIsotropic(moments)) {
    // ω is parallel to L in any orientation.
    end.w_WB = start.w_WB + dL_W / moments[0];
    end.q_WB = IntegrateRotation(start.q_WB, start.w_WB, end.w_WB, h);
    return end;
  }
  const Eigen::Vector3d inverse = moments.cwiseInverse();
  for (int count = 1;; count *= 2) {
    const double fraction = 1.0 / count;
    const Eigen::Vector3d dL_step_W = fraction * dL_W;
    end = start;
    double error = 0;
    double energy = 0;
    const bool is_last = count == kMaxSubSteps;
    for (int k = 0; k < count && (is_last || !(error > kEnergyTolerance * energy)); ++k) {
      const SubStep step =
          TakeSubStep(end.q_WB, inverse, L_W + k * dL_step_W, dL_step_W, fraction * h);
      end = step.end;
      error += step.error;
      energy = std::max(energy, step.energy);
    }
    if (is_last || !(error > kEnergyTolerance * energy)) return end;
  }
}

Eigen::Vector3d GyroscopicChange(const Eigen::Matrix3d& R_WB,
                                 const Eigen::Vector3d& moments,
                                 const Eigen::Vector3d& w_WB, double h, Gyroscopic rule) {
  if (rule == Gyroscopic::kOff || IsIsotropic(moments)) return Eigen::Vector3d::Zero();
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
