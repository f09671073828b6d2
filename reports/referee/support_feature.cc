#include "reports/referee/support_feature.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace touchstone::referee {
namespace {

using Points = std::vector<Eigen::Vector3d>;

// The number of sides of the polygon around a disc, which is 2 % wider than the disc.
constexpr int kRimSides = 16;

/** Returns points on the rim of a disc at height z. The first is the one farthest along
 n. */
Points Rim(double radius, double z, const Eigen::Vector3d& n_B) {
  const double start = std::atan2(n_B.y(), n_B.x());
  Points points;
  for (int i = 0; i < kRimSides; ++i) {
    const double angle = start + i * 2 * std::numbers::pi / kRimSides;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  return points;
}

/** Returns the points within `slack` of the farthest along n. */
Points Keep(const Points& points, const Eigen::Vector3d& n_B, double slack) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& p : points) most = std::max(most, n_B.dot(p));
  Points kept;
  for (const Eigen::Vector3d& p : points) {
    if (n_B.dot(p) >= most - slack) kept.push_back(p);
  }
  return kept;
}

/** Returns a disc that lies within slack of the plane, as a polygon around it. */
SupportFeature Disc(double radius, double z) {
  const double around = radius / std::cos(std::numbers::pi / kRimSides);
  return {Rim(around, z, Eigen::Vector3d::UnitX()), true, false};
}

/** Returns the feature in the body frame along the body-frame direction n_B. */
struct InBody {
  const Eigen::Vector3d& n_B;
  double slack;

  SupportFeature operator()(const Sphere& sphere) const {
    return {{sphere.radius * n_B}};
  }
  SupportFeature operator()(const Box& box) const {
    Points corners;
    for (int i = 0; i < 8; ++i) {
      corners.push_back(box.half_extents.cwiseProduct(
          Eigen::Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
    }
    return {Keep(corners, n_B, slack)};
  }
  SupportFeature operator()(const Capsule& capsule) const {
    SupportFeature feature{
        Keep({{0, 0, -capsule.half_length}, {0, 0, capsule.half_length}}, n_B, slack)};
    for (Eigen::Vector3d& p : feature.points_W) p += capsule.radius * n_B;
    return feature;
  }
  SupportFeature operator()(const Cylinder& cylinder) const {
    const double end = std::copysign(cylinder.half_length, n_B.z());
    if (LiesFlat(cylinder.radius)) return Disc(cylinder.radius, end);
    Points points = Rim(cylinder.radius, end, n_B);
    const Points other = Rim(cylinder.radius, -end, n_B);
    points.insert(points.end(), other.begin(), other.end());
    return {Keep(points, n_B, slack)};
  }
  SupportFeature operator()(const Cone& cone) const {
    if (n_B.z() < 0 && LiesFlat(cone.radius)) return Disc(cone.radius, -cone.half_height);
    Points points = Rim(cone.radius, -cone.half_height, n_B);
    points.emplace_back(0, 0, cone.half_height);
    return {Keep(points, n_B, slack)};
  }
  SupportFeature operator()(const ConvexHull& hull) const {
    return {Keep(hull.vertices, n_B, slack)};
  }
  SupportFeature operator()(const HalfSpace&) const { return {{}, false, true}; }

  bool LiesFlat(double radius) const {
    return 2 * radius * std::hypot(n_B.x(), n_B.y()) <= slack;
  }
};

}  // namespace

SupportFeature FeatureAlong(const Body& body, const Eigen::Vector3d& n_W, double slack) {
  const Eigen::Vector3d n_B = body.X_WB.R_WB.transpose() * n_W;
  SupportFeature feature = std::visit(InBody{n_B, slack}, body.shape);
  for (Eigen::Vector3d& p : feature.points_W) p = body.X_WB * p;
  return feature;
}

}  // namespace touchstone::referee
