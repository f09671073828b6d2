#include "engine/printed/body_motion.h"

namespace cookbook::printed {
namespace {

/** The fraction of a velocity that is left after a step under E-11. */
constexpr double kKept = 0.98;

Eigen::Quaterniond FromAngles(const Eigen::Vector3d& angles) {
  return Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX());
}

bool IsSphere(const Body& body) {
  return std::holds_alternative<Sphere>(body.shape);
}

/** Returns the gyroscopic torque ω × (I ω). World frame. [N m] */
Eigen::Vector3d GyroscopicTorque(const Body& body) {
  const Eigen::Matrix3d R = body.q_WB.toRotationMatrix();
  const Eigen::Vector3d w_B = R.transpose() * body.w_WB;
  return R * w_B.cross(body.inertia.cwiseProduct(w_B));
}

}  // namespace

Eigen::Vector3d SolidInertia(const Body& body) {
  if (const auto* sphere = std::get_if<Sphere>(&body.shape))
    return Eigen::Vector3d::Constant(0.4 * body.mass * sphere->radius * sphere->radius);
  const Eigen::Vector3d squares = std::get<Box>(body.shape).half_extents.cwiseAbs2();
  return body.mass / 3 * (Eigen::Vector3d::Constant(squares.sum()) - squares);
}

double InverseMass(const Body& body) {
  return body.mass == 0 ? 0 : 1 / body.mass;
}

Eigen::Matrix3d InverseInertia(const Body& body, const Errata& errata) {
  if (body.mass == 0) return Eigen::Matrix3d::Zero();
  const Eigen::Vector3d moments = body.inertia.cwiseInverse();
  if (errata.Has(Erratum::kE14)) return moments.asDiagonal();
  const Eigen::Matrix3d R = body.q_WB.toRotationMatrix();
  return R * moments.asDiagonal() * R.transpose();
}

void Give(Body& body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& J_W,
          const Errata& errata) {
  body.v_WB += InverseMass(body) * J_W;
  body.w_WB += InverseInertia(body, errata) * (p_W - body.p_WB).cross(J_W);
}

void Turn(Body& body, const Eigen::Vector3d& turn_W, const Errata& errata) {
  if (errata.Has(Erratum::kE15)) {
    body.angles += turn_W;
    body.q_WB = FromAngles(body.angles);
    return;
  }
  const Eigen::Quaterniond rate(0, turn_W.x(), turn_W.y(), turn_W.z());
  body.q_WB.coeffs() += 0.5 * (rate * body.q_WB).coeffs();
  body.q_WB.normalize();
}

void Integrate(Body& body, const Eigen::Vector3d& gravity_W, double dt,
               const Errata& errata) {
  if (body.mass == 0) return;
  body.v_WB += dt * (gravity_W + body.force_W / body.mass);
  if (!errata.Has(Erratum::kE16))
    body.w_WB -= dt * (InverseInertia(body, errata) * GyroscopicTorque(body));
  const bool turns = !(IsSphere(body) && errata.Has(Erratum::kE13));
  if (errata.Has(Erratum::kE11)) {
    body.v_WB *= kKept;
    if (turns) body.w_WB *= kKept;
  }
  body.p_WB += dt * body.v_WB;
  if (turns) Turn(body, dt * body.w_WB, errata);
}

Eigen::Vector3d VelocityAt(const Body& body, const Eigen::Vector3d& p_W) {
  return body.v_WB + body.w_WB.cross(p_W - body.p_WB);
}

}  // namespace cookbook::printed
