#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

#include "reports/shrink/reductions.h"
#include "scenarios/cube_rotations.h"

namespace touchstone {
namespace {

/** Returns the quaternion of integers divided by the integer `n` that is nearest to `q`
 among those whose integers are at most 2 from n q and whose squares add up to n²: it is a
 unit quaternion with few digits, if n divides a power of ten. Zero if there is none. */
Eigen::Quaterniond NearestWithDenominator(const Eigen::Quaterniond& q, double n) {
  const Eigen::Vector4d exact = n * q.coeffs();
  Eigen::Vector4d best = Eigen::Vector4d::Zero();
  constexpr int kReach = 2;
  constexpr int kChoices = 2 * kReach + 1;
  for (int code = 0; code < kChoices * kChoices * kChoices * kChoices; ++code) {
    Eigen::Vector4d integers;
    for (int k = 0, rest = code; k < 4; ++k, rest /= kChoices)
      integers[k] = std::round(exact[k]) + rest % kChoices - kReach;
    if (integers.squaredNorm() != n * n) continue;
    if (best.isZero() || (integers - exact).norm() < (best - exact).norm())
      best = integers;
  }
  // Adding 0 turns -0 into 0.
  return Eigen::Quaterniond(Eigen::Vector4d((best / n).array() + 0.0));
}

/** Returns the rotations that could replace that of `X`, at the same place. */
std::vector<Pose> PlainerThan(const Pose& X) {
  const Eigen::Vector3d& p = X.p_WB;
  std::vector<Pose> plainer = {Pose::FromQuaternion(p, Eigen::Quaterniond::Identity())};
  Eigen::Matrix3d nearest = Eigen::Matrix3d::Identity();
  for (int i = 0; i < kCubeRotations; ++i) {
    const Eigen::Matrix3d R = CubeRotation(i);
    if ((R - X.R_WB).norm() < (nearest - X.R_WB).norm()) nearest = R;
  }
  plainer.push_back(Pose::FromMatrix(p, nearest));
  const Eigen::Quaterniond q = X.q_WB ? *X.q_WB : Eigen::Quaterniond(X.R_WB).normalized();
  for (const double n : {2., 5., 10., 25., 50., 100., 500., 1e3, 1e4, 1e5}) {
    const Eigen::Quaterniond shorter = NearestWithDenominator(q, n);
    if (!shorter.coeffs().isZero()) plainer.push_back(Pose::FromQuaternion(p, shorter));
  }
  // About one axis only, the same angle.
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Quaterniond about(q.w(), 0, 0, 0);
    about.coeffs()[axis] = q.coeffs()[axis];
    if (about.norm() > 0.5)
      plainer.push_back(Pose::FromQuaternion(p, about.normalized()));
  }
  plainer.push_back(Pose::FromQuaternion(p, q));
  return plainer;
}

}  // namespace

void PlainRotations(const Question& question, const Candidates& take) {
  const std::vector<const Body*> bodies = BodiesOf(question);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (const Pose& plain : PlainerThan(bodies[i]->X_WB)) {
      Question turned = question;
      BodiesOf(turned)[i]->X_WB = plain;
      take(std::move(turned));
    }
  }
}

}  // namespace touchstone
