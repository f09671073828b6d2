#include "scenarios/validate.h"

#include <cmath>
#include <string_view>

#include <Eigen/LU>
#include <fmt/format.h>

#include "scenarios/limits.h"

namespace touchstone {
namespace {

void CheckFinite(const std::string& where, double value, std::vector<Fault>& faults) {
  if (std::isfinite(value)) return;
  faults.push_back({where, fmt::format("is {}", value), "a finite number"});
}

bool IsInRange(double length) {
  return length >= kShortest && length <= kLongest;
}

void CheckLength(const std::string& where, double value, std::vector<Fault>& faults) {
  // Written so that a NaN is a fault.
  if (!(value > 0 && std::isfinite(value))) {
    faults.push_back({where, fmt::format("is {}", value), "a finite length > 0"});
  } else if (!IsInRange(value)) {
    faults.push_back({where, fmt::format("is {}", value),
                      fmt::format("a length from {} to {} m", kShortest, kLongest)});
  }
}

void CheckPoint(std::string_view where, const Eigen::Vector3d& point,
                std::vector<Fault>& faults) {
  for (int i = 0; i < 3; ++i) {
    CheckFinite(fmt::format("{}[{}]", where, i), point[i], faults);
  }
}

/** Like CheckPoint(), but each coordinate must also be 0 or a length in range. */
void CheckPlace(std::string_view where, const Eigen::Vector3d& place,
                std::vector<Fault>& faults) {
  CheckPoint(where, place, faults);
  for (int i = 0; i < 3; ++i) {
    const double x = place[i];
    if (!std::isfinite(x) || x == 0 || IsInRange(std::abs(x))) continue;
    faults.push_back(
        {fmt::format("{}[{}]", where, i), fmt::format("is {}", x),
         fmt::format("0 m, or a magnitude from {} to {} m", kShortest, kLongest)});
  }
}

struct ShapeCheck {
  std::vector<Fault>& faults;

  void operator()(const Sphere& sphere) const {
    CheckLength("radius", sphere.radius, faults);
  }
  void operator()(const Box& box) const {
    for (int i = 0; i < 3; ++i) {
      CheckLength(fmt::format("half_extents[{}]", i), box.half_extents[i], faults);
    }
  }
  void operator()(const Capsule& capsule) const {
    CheckLength("radius", capsule.radius, faults);
    CheckLength("half_length", capsule.half_length, faults);
  }
  void operator()(const Cylinder& cylinder) const {
    CheckLength("radius", cylinder.radius, faults);
    CheckLength("half_length", cylinder.half_length, faults);
  }
  void operator()(const Cone& cone) const {
    CheckLength("radius", cone.radius, faults);
    CheckLength("half_height", cone.half_height, faults);
  }
  void operator()(const ConvexHull& hull) const {
    if (hull.vertices.empty()) {
      faults.push_back({"vertices", "is empty", "at least one vertex"});
    }
    if (hull.vertices.size() > kMostVertices) {
      faults.push_back({"vertices", fmt::format("has {} points", hull.vertices.size()),
                        fmt::format("at most {}", kMostVertices)});
      return;
    }
    for (std::size_t i = 0; i < hull.vertices.size(); ++i) {
      CheckPlace(fmt::format("vertices[{}]", i), hull.vertices[i], faults);
    }
  }
  void operator()(const HalfSpace&) const {}
};

void CheckQuaternion(const Pose& pose, std::vector<Fault>& faults) {
  const Eigen::Vector4d wxyz(pose.q_WB->w(), pose.q_WB->x(), pose.q_WB->y(),
                             pose.q_WB->z());
  if (!wxyz.allFinite()) {
    for (int i = 0; i < 4; ++i) {
      CheckFinite(fmt::format("quaternion[{}]", i), wxyz[i], faults);
    }
    return;
  }
  // stableNorm: the norm of components near the largest double must not overflow.
  const double norm = wxyz.stableNorm();
  if (!(std::abs(norm - 1) <= kQuaternionSlack)) {
    faults.push_back(
        {"quaternion", fmt::format("has norm {}", norm),
         fmt::format("a unit quaternion w, x, y, z: of norm 1 to {} in a file, to {} "
                     "in a program",
                     kRotationSlack, kQuaternionSlack)});
  } else if (pose.R_WB != pose.q_WB->toRotationMatrix()) {
    faults.push_back({"quaternion", "does not match the pose's rotation matrix",
                      "a pose made by Pose::FromQuaternion"});
  }
}

void CheckRotation(const Eigen::Matrix3d& R, std::vector<Fault>& faults) {
  if (!R.allFinite()) {
    for (int row = 0; row < 3; ++row) {
      CheckPoint(fmt::format("rotation[{}]", row), R.row(row).transpose(), faults);
    }
    return;
  }
  const double defect = OrthonormalityDefect(R);
  if (!(defect <= kRotationSlack)) {
    faults.push_back(
        {"rotation", fmt::format("deviates from orthonormal by {:.3g}", defect),
         fmt::format("three orthonormal rows of determinant +1, to {}", kRotationSlack)});
  } else if (R.determinant() < 0) {
    faults.push_back({"rotation", "mirrors: its determinant is -1",
                      "three orthonormal rows of determinant +1"});
  }
}

void AppendPrefixed(std::string_view prefix, std::vector<Fault> from,
                    std::vector<Fault>& to) {
  for (Fault& fault : from) {
    fault.where.insert(0, prefix);
    to.push_back(std::move(fault));
  }
}

}  // namespace

std::optional<double> NormToDivideBy(const Eigen::Quaterniond& q) {
  const double norm = q.coeffs().stableNorm();
  const double off = std::abs(norm - 1);
  // Written so that a NaN is left to the validation.
  if (off > kQuaternionSlack && off <= kRotationSlack) return norm;
  return std::nullopt;
}

std::vector<Fault> FaultsOf(const Body& body) {
  std::vector<Fault> faults;
  std::visit(ShapeCheck{faults}, body.shape);
  CheckPlace("position", body.X_WB.p_WB, faults);
  if (body.X_WB.q_WB) {
    CheckQuaternion(body.X_WB, faults);
  } else {
    CheckRotation(body.X_WB.R_WB, faults);
  }
  return faults;
}

std::vector<Fault> FaultsOf(const ContactQuery& query) {
  std::vector<Fault> faults;
  AppendPrefixed("A.", FaultsOf(query.A), faults);
  AppendPrefixed("B.", FaultsOf(query.B), faults);
  if (KindOf(query.A.shape) == ShapeKind::kHalfSpace &&
      KindOf(query.B.shape) == ShapeKind::kHalfSpace) {
    faults.push_back({"B.shape", "is a half_space, and so is the other body's",
                      "at most one half_space"});
  }
  return faults;
}

}  // namespace touchstone
