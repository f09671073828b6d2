#include "engine/dynamics/body/rotation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

/** Limits of the iterations of IntegrateWithLeverArms(). */
constexpr int kMaxCayleyIterations = 50;
constexpr double kLeastCayleyFraction = 1.0 / 64;
constexpr int kMaxCayleyParts = 64;
constexpr double kCayleyRounding = 1e-16;
/** Greatest error of a solution, relative to the angular momentum in the metric of the
 kinetic energy. A few roundings of the greatest moment remain, which are more of the
 least: 100 for a bar of 1 : 10. */
constexpr double kCayleyTolerance = 1e-12;

/** Relative energy error beyond which a step is divided into sub-steps. A thin rod that
 turns by half a radian in one step doubles its energy. A box of 1 : 4 : 9 that turns by a
 twelfth of a radian has an error of 1e-8, and needs no sub-steps. */
constexpr double kEnergyTolerance = 1e-6;

/** Maximum number of sub-steps. A needle of 1 : 70 that turns by sixteen radians needs
 half as many. */
constexpr int kMaxSubSteps = 256;

/** Relative rounding error of a kinetic energy that is a sum of energy and work. */
constexpr double kEnergyRounding = 16 * 0x1p-53;

/** The result of a sub-step. */
struct SubStep {
  AngularState end;
  double energy;  ///< Greater kinetic energy of start and end, times 2 h. [J s]
  double work;    ///< Work of the change of angular momentum, times 2 h. [J s]
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
  step.work = dL_W.dot(k1 + 2 * (k2 + k3) + k4) / 3;
  step.energy = std::max(std::abs(before), std::abs(after));
  step.error = std::abs(after - before - step.work);
  return step;
}

/** The kinetic energy of a body that is not isotropic, for one magnitude of its angular
 momentum. With l = L/|L| in the body frame and the inverse moments a, the energy is
 ½ |L|² (a_k + e), where e = Σ (a_i − a_k) l_i². The axis k is near l, so that e has no
 rounding error of the size of a_k. */
struct EnergyLevels {
  Eigen::Vector3d slopes;  ///< a_i − a_k. [1/(kg m²)]
  double reference;        ///< a_k. [1/(kg m²)]

  EnergyLevels(const Eigen::Vector3d& inverse, const Eigen::Vector3d& l_B) {
    Eigen::Index nearest = 0;
    l_B.cwiseAbs().maxCoeff(&nearest);
    reference = inverse[nearest];
    slopes = inverse.array() - reference;
  }
  /** Returns e of the unit vector l. */
  double At(const Eigen::Vector3d& l_B) const {
    return l_B.dot(slopes.cwiseProduct(l_B));
  }
};

/** Turns a body with the angular momentum L_W until its energy is at the level `target`,
 which has a rounding error of up to `rounding`: if the body is nearly isotropic, a turn
 that removes that could be large. Returns whether there is such an orientation; otherwise
 the state does not change.

 The projection of an integrator onto its invariants (Hairer, Lubich & Wanner, Geometric
 Numerical Integration, IV.4). A turn of l by θ in the plane of l and a unit vector g ⊥ l
 changes its level e by −(e − c) sin²θ + 2 s sin θ cos θ, where s = Σ (a_i − a_k) l_i g_i
 and c is the level of g. This is a quadratic equation for tan θ.

 The first g is the gradient of e, with the least turn. Near a principal axis its circle
 may miss the target. The second g points away from the axis of least energy or to that of
 greatest energy. Its circle contains the axis, and every level between. */
bool SetEnergy(const EnergyLevels& levels, const Eigen::Vector3d& L_W, double target,
               double rounding, Eigen::Quaterniond& q_WB) {
  const Eigen::Vector3d l = (q_WB.conjugate() * L_W).normalized();
  const double e = levels.At(l);
  const double change = target - e;
  const auto turn_towards = [&](const Eigen::Vector3d& direction) {
    const Eigen::Vector3d across = direction - l.dot(direction) * l;
    if (across.isZero(0)) return false;
    const Eigen::Vector3d g = across.normalized();
    const double s = l.dot(levels.slopes.cwiseProduct(g));
    const double discriminant = s * s - change * (change + e - levels.At(g));
    if (!(discriminant >= 0)) return false;
    const double theta = std::atan2(change, s + std::sqrt(discriminant));
    q_WB = (q_WB * Exp(-theta * l.cross(g))).normalized();
    return true;
  };
  if (std::abs(change) <= rounding || turn_towards(levels.slopes.cwiseProduct(l)))
    return true;
  Eigen::Index axis = 0;
  if (change < 0) {
    levels.slopes.minCoeff(&axis);
  } else {
    levels.slopes.maxCoeff(&axis);
  }
  const double sign = (l[axis] < 0) == (change < 0) ? 1 : -1;
  return turn_towards(sign * Eigen::Vector3d::Unit(axis));
}

/** Returns `end` with its energy set by SetEnergy(), its angular velocity, and whether
 the energy is right. */
std::pair<AngularState, bool> Projected(const EnergyLevels& levels,
                                        const Eigen::Vector3d& L_W, double target,
                                        double rounding, const Eigen::Vector3d& inverse,
                                        AngularState end) {
  const bool is_right = SetEnergy(levels, L_W, target, rounding, end.q_WB);
  end.w_WB = WorldInertiaTimes(end.q_WB.toRotationMatrix(), inverse, L_W);
  return {end, is_right};
}

/** IntegrateAngularMomentum() of a body that is not isotropic. Returns also whether the
 energy is right. */
std::pair<AngularState, bool> IntegrateAnisotropic(const AngularState& start,
                                                   const Eigen::Vector3d& inverse,
                                                   const Eigen::Vector3d& L_W,
                                                   const AngularImpulse& impulse,
                                                   double h) {
  AngularState end;
  double work = 0;
  for (int count = 1;; count *= 2) {
    const double fraction = 1.0 / count;
    const Eigen::Vector3d dL_step_W = fraction * impulse.dL_W;
    end = start;
    work = 0;
    double error = 0;
    double energy = 0;
    const bool is_last = count == kMaxSubSteps;
    for (int k = 0; k < count && (is_last || !(error > kEnergyTolerance * energy)); ++k) {
      const SubStep step =
          TakeSubStep(end.q_WB, inverse, L_W + k * dL_step_W, dL_step_W, fraction * h);
      end = step.end;
      work += step.work * count / (2 * h);
      error += step.error;
      energy = std::max(energy, step.energy);
    }
    if (is_last || !(error > kEnergyTolerance * energy)) break;
  }
  const Eigen::Vector3d L_end_W = L_W + impulse.dL_W;
  const double L_end_squared = L_end_W.squaredNorm();
  if (!(L_end_squared > 0)) return {end, true};
  const Eigen::Vector3d l_start = (start.q_WB.conjugate() * L_W).normalized();
  const EnergyLevels at_start(inverse, l_start);
  const double level = at_start.At(l_start);
  if (impulse.dL_W.isZero(0)) return Projected(at_start, L_end_W, level, 0, inverse, end);
  // After an impulse the angular momentum may be near another axis. Before one from rest,
  // it has no direction: levels about an axis that it is not near would have rounding
  // errors for which SetEnergy() would turn the body far.
  const EnergyLevels at_end(inverse, (end.q_WB.conjugate() * L_end_W).normalized());
  const double twice_energy = L_W.squaredNorm() * (at_start.reference + level);
  const double twice_work = 2 * impulse.work.value_or(work);
  const double target = (twice_energy + twice_work) / L_end_squared - at_end.reference;
  const double rounding =
      kEnergyRounding * (twice_energy + std::abs(twice_work)) / L_end_squared;
  return Projected(at_end, L_end_W, target, rounding, inverse, end);
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
                                      const AngularImpulse& impulse, double h) {
  if (IsIsotropic(moments)) {
    // ω is parallel to L in any orientation, and the energy is a function of L.
    AngularState end;
    end.w_WB = start.w_WB + impulse.dL_W / moments[0];
    end.q_WB = IntegrateRotation(start.q_WB, start.w_WB, end.w_WB, h);
    return end;
  }
  const Eigen::Vector3d inverse = moments.cwiseInverse();
  const auto [end, is_right] = IntegrateAnisotropic(start, inverse, L_W, impulse, h);
  if (is_right || !impulse.work) return end;
  // An impulse at the start of the step, then torque-free rotation: the energy after the
  // impulse is one that this angular momentum can have.
  return IntegrateAnisotropic(start, inverse, L_W + impulse.dL_W,
                              {Eigen::Vector3d::Zero(), 0}, h)
      .first;
}

namespace {

/** Returns D of the differential of the Cayley map, cay(x)⁻¹ d cay(x) = [D dx]×. */
Eigen::Matrix3d CayleyDifferential(const Eigen::Vector3d& x) {
  const double scale = 1 / (1 + 0.25 * x.squaredNorm());
  Eigen::Matrix3d D = scale * Eigen::Matrix3d::Identity();
  for (int j = 0; j < 3; ++j) D.col(j) -= 0.5 * scale * x.cross(Eigen::Vector3d::Unit(j));
  return D;
}

/** Returns the derivative of 2 I x / h − Π₀ − cay(x)ᵀ p with respect to x. `end_B` is
 Π₁ = cay(x)ᵀ p. */
Eigen::Matrix3d LeverArmJacobian(const Eigen::Vector3d& x, const Eigen::Vector3d& moments,
                                 const Eigen::Vector3d& end_B, double h) {
  Eigen::Matrix3d jacobian = (2 / h * moments).asDiagonal();
  const Eigen::Matrix3d D = CayleyDifferential(x);
  for (int j = 0; j < 3; ++j) jacobian.col(j) -= end_B.cross(D.col(j));
  return jacobian;
}

}  // namespace

LeverArmState IntegrateWithLeverArms(const AngularState& start,
                                     const Eigen::Vector3d& moments,
                                     const Eigen::Vector3d& L_W,
                                     const Eigen::Vector3d& dL_W, double h) {
  const auto cayley = [](const Eigen::Vector3d& x) {
    return Eigen::Quaterniond(1, 0.5 * x[0], 0.5 * x[1], 0.5 * x[2]).normalized();
  };
  LeverArmState end;
  if (IsIsotropic(moments)) {
    // The energy is a function of L, and the Cayley map has the secant of every arm.
    end.w_WB = start.w_WB + dL_W / moments[0];
    end.q_WB = (cayley(0.5 * h * (start.w_WB + end.w_WB)) * start.q_WB).normalized();
    return end;
  }
  // Newton's method for 2 I x / h − Π₀ − cay(x)ᵀ p = 0. A thin bar that turns by a third
  // of a radian needs damping: the full step may lead away from the solution.
  const Eigen::Vector3d start_B = start.q_WB.conjugate() * L_W;
  const Eigen::Vector3d p = start.q_WB.conjugate() * (L_W + dL_W);
  const auto energy_of = [&](const Eigen::Vector3d& residual) {
    return residual.dot(residual.cwiseQuotient(moments));
  };
  const double size = energy_of(start_B) + energy_of(p);
  // Solves for a step of `time`, from the initial guess `x`. Returns whether it is
  // solved.
  const auto solve = [&](double time, Eigen::Vector3d& x) {
    const auto residual_at = [&](const Eigen::Vector3d& at) -> Eigen::Vector3d {
      return 2 / time * moments.cwiseProduct(at) - start_B - cayley(at).conjugate() * p;
    };
    Eigen::Vector3d residual = residual_at(x);
    double error = energy_of(residual);
    for (int k = 0; k < kMaxCayleyIterations; ++k) {
      const Eigen::Vector3d end_B = cayley(x).conjugate() * p;
      const Eigen::Vector3d change =
          LeverArmJacobian(x, moments, end_B, time).inverse() * residual;
      double fraction = 1;
      Eigen::Vector3d next = residual_at(x - change);
      while (!(energy_of(next) < error) && fraction > kLeastCayleyFraction) {
        fraction /= 2;
        next = residual_at(x - fraction * change);
      }
      // The convergence is quadratic until roundings are left.
      if (!(energy_of(next) < error)) break;
      x -= fraction * change;
      residual = next;
      error = energy_of(next);
      if (change.norm() <= kCayleyRounding * x.norm()) break;
    }
    return error <= kCayleyTolerance * kCayleyTolerance * size;
  };
  Eigen::Vector3d x = 0.5 * h * (start_B + p).cwiseQuotient(moments);
  end.is_solved = solve(h, x);
  // Continuation in the time: each solution is the initial guess of a longer step.
  for (int parts = 4; !end.is_solved && parts <= kMaxCayleyParts; parts *= 4) {
    x = 0.5 * h / parts * (start_B + p).cwiseQuotient(moments);
    end.is_solved = solve(h / parts, x);
    for (int k = 2; end.is_solved && k <= parts; ++k) {
      x *= static_cast<double>(k) / (k - 1);
      end.is_solved = solve(k * h / parts, x);
    }
  }
  end.q_WB = (start.q_WB * cayley(x)).normalized();
  end.w_WB =
      WorldInertiaTimes(end.q_WB.toRotationMatrix(), moments.cwiseInverse(), L_W + dL_W);
  return end;
}

Eigen::Matrix3d LeverArmResponse(const AngularState& start, const AngularState& end,
                                 const Eigen::Vector3d& moments, double h) {
  const Eigen::Quaterniond turn = start.q_WB.conjugate() * end.q_WB;
  const Eigen::Vector3d x = 2 / turn.w() * turn.vec();
  const Eigen::Matrix3d R_end = end.q_WB.toRotationMatrix();
  const Eigen::Vector3d end_B = moments.cwiseProduct(R_end.transpose() * end.w_WB);
  return R_end * CayleyDifferential(x) *
         LeverArmJacobian(x, moments, end_B, h).inverse() * R_end.transpose();
}

Eigen::Vector3d SpinAfterCorrection(const Eigen::Matrix3d& R_from,
                                    const Eigen::Matrix3d& R_to,
                                    const Eigen::Vector3d& moments,
                                    const Eigen::Vector3d& w_WB) {
  const Eigen::Vector3d w_B = R_from.transpose() * w_WB;
  const Eigen::Vector3d L_B = moments.cwiseProduct(w_B);
  const Eigen::Vector3d L_W = R_from * L_B;
  const Eigen::Vector3d kept_L_B = R_to.transpose() * L_W;
  const Eigen::Vector3d kept_w_B = kept_L_B.cwiseQuotient(moments);
  const double kept_energy = kept_w_B.dot(kept_L_B);
  if (kept_energy == 0) return w_WB;
  const double scale = std::sqrt(w_B.dot(L_B) / kept_energy);
  const double change_if_turned = (R_to * L_B - L_W).norm();
  const double change_if_scaled = std::abs(scale - 1) * L_W.norm();
  const Eigen::Vector3d w_to_B =
      change_if_scaled < change_if_turned ? Eigen::Vector3d(scale * kept_w_B) : w_B;
  return R_to * w_to_B;
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
