#include "reports/contacts/checks/mixed_normals.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "reports/contacts/checks/judged_answer.h"

namespace touchstone {

double AngleBetween(const Eigen::Vector3d& m, const Eigen::Vector3d& n) {
  return std::atan2(m.cross(n).norm(), m.dot(n));
}

double MixedNormals(const ContactAnswer& answer) {
  std::vector<Eigen::Vector3d> normals;
  if (answer.n_AB_W) normals.push_back(*answer.n_AB_W);
  for (const ContactPoint& contact : answer.points) {
    if (contact.n_AB_W) normals.push_back(*contact.n_AB_W);
  }
  double largest = 0;
  for (const Eigen::Vector3d& m : normals) {
    for (const Eigen::Vector3d& n : normals)
      largest = std::max(largest, AngleBetween(m, n));
  }
  return largest;
}

void CheckMixedNormals(JudgedAnswer& judged) {
  const ContactAnswer& answer = judged.answer;
  const bool has_two =
      answer.points.size() > 1 || (answer.points.size() == 1 && answer.n_AB_W);
  if (!has_two) return;
  const double angle = MixedNormals(answer);
  judged.Judge(
      {MeasureKind::kMixedNormals, angle, judged.tolerances.angle},
      [&] { return judged.because.Angle(); },
      [&]() -> Proof { return {.kind = ProofKind::kMixedNormals, .rest = angle}; });
}

}  // namespace touchstone
