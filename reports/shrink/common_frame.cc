#include <cstddef>

#include "reports/shrink/reductions.h"

namespace touchstone {
namespace {

/** Returns the pose of `X_WB` seen from `X_WA`. The form of the rotation, quaternion or
 matrix, is kept if both have a quaternion. */
Pose Relative(const Pose& X_WA, const Pose& X_WB) {
  const Eigen::Matrix3d R_AW = X_WA.R_WB.transpose();
  const Eigen::Vector3d p_AB = R_AW * (X_WB.p_WB - X_WA.p_WB);
  if (!X_WA.q_WB || !X_WB.q_WB) return Pose::FromMatrix(p_AB, R_AW * X_WB.R_WB);
  const Eigen::Quaterniond q_AB = (X_WA.q_WB->conjugate() * *X_WB.q_WB).normalized();
  return Pose::FromQuaternion(p_AB, q_AB);
}

}  // namespace

void CommonFrame(const Question& question, const Candidates& take) {
  const std::vector<const Body*> bodies = BodiesOf(question);
  if (std::holds_alternative<Scenario>(question)) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      Question moved = question;
      const std::size_t other = 1 - i;
      BodiesOf(moved)[other]->X_WB = Relative(bodies[i]->X_WB, bodies[other]->X_WB);
      BodiesOf(moved)[i]->X_WB =
          Pose::FromQuaternion(Eigen::Vector3d::Zero(), Eigen::Quaterniond::Identity());
      take(std::move(moved));
    }
  }
  for (const Body* const body : bodies) {
    Question moved = question;
    for (Body* const each : BodiesOf(moved)) each->X_WB.p_WB -= body->X_WB.p_WB;
    take(std::move(moved));
  }
}

}  // namespace touchstone
