#include "reports/shrink/shifts.h"

#include <numbers>

#include "reports/contacts/body_size.h"

namespace touchstone {
namespace {

/** Returns the vertices of a dodecahedron about the origin: those of a cube, and of three
 rectangles in the coordinate planes with the sides 2 φ and 2/φ. */
std::vector<Eigen::Vector3d> Dodecahedron() {
  constexpr double kPhi = std::numbers::phi;
  std::vector<Eigen::Vector3d> vertices;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-1.0, 1.0}) {
      for (const double c : {-1.0, 1.0}) vertices.emplace_back(a, b, c);
      vertices.emplace_back(0, a / kPhi, b * kPhi);
      vertices.emplace_back(a / kPhi, b * kPhi, 0);
      vertices.emplace_back(b * kPhi, 0, a / kPhi);
    }
  }
  return vertices;
}

}  // namespace

std::vector<Scenario> ShiftsOf(const Scenario& scenario) {
  const double shift = 0.01 * SmallestFeature(scenario.contact);
  const double angle = shift / SmallerExtent(scenario.contact);
  std::vector<Scenario> shifts;
  for (const Eigen::Vector3d& vertex : Dodecahedron()) {
    const Eigen::Vector3d axis = vertex.normalized();
    Scenario& shifted = shifts.emplace_back(scenario);
    shifted.expect = {};
    shifted.indicts.clear();
    Pose& pose = shifted.contact.B.X_WB;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, axis));
    pose = Pose::FromQuaternion(pose.p_WB + shift * axis,
                                (turn * Eigen::Quaterniond(pose.R_WB)).normalized());
  }
  return shifts;
}

}  // namespace touchstone
