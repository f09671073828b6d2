#include "reports/measures/mixed_normals.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

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

}  // namespace touchstone
