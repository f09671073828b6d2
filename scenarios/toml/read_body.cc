#include "scenarios/toml/read_body.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "scenarios/toml/values.h"
#include "scenarios/validate.h"

namespace touchstone {
namespace {

Shape ShapeFrom(const toml::table& body) {
  const std::string name = TextFrom(body, "shape");
  const auto length = [&](std::string_view key) { return NumberFrom(body.get(key), 1); };
  if (name == NameOf(ShapeKind::kSphere)) return Sphere{length("radius")};
  if (name == NameOf(ShapeKind::kBox)) {
    return Box{VectorFrom(body.get("half_extents"), Eigen::Vector3d::Ones())};
  }
  if (name == NameOf(ShapeKind::kCapsule)) {
    return Capsule{length("radius"), length("half_length")};
  }
  if (name == NameOf(ShapeKind::kCylinder)) {
    return Cylinder{length("radius"), length("half_length")};
  }
  if (name == NameOf(ShapeKind::kCone)) {
    return Cone{length("radius"), length("half_height")};
  }
  if (name == NameOf(ShapeKind::kConvexHull)) {
    if (const toml::array* vertices = body["vertices"].as_array()) {
      return ConvexHull{PointsFrom(*vertices)};
    }
    return ConvexHull{{Eigen::Vector3d::Zero()}};
  }
  if (name == NameOf(ShapeKind::kHalfSpace)) return HalfSpace{};
  return Sphere{1};
}

/** Returns the quaternion in `wxyz`, divided by NormToDivideBy() with a note. */
Eigen::Quaterniond QuaternionFrom(const toml::array& wxyz, FileLog& log) {
  Eigen::Quaterniond q(NumberFrom(wxyz.get(0), 1), NumberFrom(wxyz.get(1), 0),
                       NumberFrom(wxyz.get(2), 0), NumberFrom(wxyz.get(3), 0));
  const std::optional<double> norm = NormToDivideBy(q);
  if (!norm) return q;
  log.Note(wxyz.source(),
           fmt::format("the quaternion has norm {}; it was divided by it", *norm));
  return Eigen::Quaterniond(Eigen::Vector4d(q.coeffs() / *norm));
}

Pose PoseFrom(const toml::table& body, FileLog& log) {
  const Eigen::Vector3d p_WB = VectorFrom(body.get("position"), Eigen::Vector3d::Zero());
  const toml::array* rows = body["rotation"].as_array();
  if (rows && rows->size() == 3 &&
      std::all_of(rows->begin(), rows->end(),
                  [](const toml::node& row) { return AreNumbers(&row, 3); })) {
    Eigen::Matrix3d R_WB;
    for (int i = 0; i < 3; ++i) {
      R_WB.row(i) =
          VectorFrom(rows->get(static_cast<std::size_t>(i)), Eigen::Vector3d::Unit(i));
    }
    return Pose::FromMatrix(p_WB, R_WB);
  }
  if (AreNumbers(body.get("quaternion"), 4)) {
    return Pose::FromQuaternion(p_WB,
                                QuaternionFrom(*body["quaternion"].as_array(), log));
  }
  return Pose::FromQuaternion(p_WB, Eigen::Quaterniond::Identity());
}

}  // namespace

Body BodyFrom(const toml::table& body, FileLog& log) {
  return {ShapeFrom(body), PoseFrom(body, log)};
}

}  // namespace touchstone
