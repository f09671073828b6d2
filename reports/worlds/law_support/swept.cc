#include "reports/worlds/law_support/swept.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "reports/referee/referee.h"
#include "reports/worlds/law_support/overlap.h"

namespace touchstone {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/** Number of points on each circle of a curved shape. */
constexpr int kPointsOfCircle = 12;

/** The largest turn between two states at which the hull of both is swept. [rad] */
constexpr double kMostTurn = 1;

void AddCircle(double radius, double z, Points& points) {
  for (int i = 0; i < kPointsOfCircle; ++i) {
    const double angle = 2 * std::numbers::pi * i / kPointsOfCircle;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
}

/** Returns points of a shape whose hull lies in it, and is it for a box and a hull. */
struct PointsOf {
  Points operator()(const Sphere&) const { return {Eigen::Vector3d::Zero()}; }
  Points operator()(const HalfSpace&) const { return {}; }
  Points operator()(const ConvexHull& hull) const { return hull.vertices; }
  Points operator()(const Box& box) const {
    Points points;
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1,
                                 corner & 4 ? 1 : -1);
      points.emplace_back(sign.cwiseProduct(box.half_extents));
    }
    return points;
  }
  Points operator()(const Capsule& capsule) const {
    Points points = {{0, 0, capsule.half_length + capsule.radius},
                     {0, 0, -capsule.half_length - capsule.radius}};
    AddCircle(capsule.radius, capsule.half_length, points);
    AddCircle(capsule.radius, -capsule.half_length, points);
    return points;
  }
  Points operator()(const Cylinder& cylinder) const {
    Points points;
    AddCircle(cylinder.radius, cylinder.half_length, points);
    AddCircle(cylinder.radius, -cylinder.half_length, points);
    return points;
  }
  Points operator()(const Cone& cone) const {
    Points points = {{0, 0, cone.half_height}};
    AddCircle(cone.radius, -cone.half_height, points);
    return points;
  }
};

/** A ball about the body origin inside a shape. */
struct BallIn {
  double operator()(const Sphere& sphere) const { return sphere.radius; }
  double operator()(const HalfSpace&) const { return 0; }
  // Its origin may be anywhere.
  double operator()(const ConvexHull&) const { return 0; }
  double operator()(const Box& box) const { return box.half_extents.minCoeff(); }
  double operator()(const Capsule& capsule) const { return capsule.radius; }
  double operator()(const Cylinder& cylinder) const {
    return std::min(cylinder.radius, cylinder.half_length);
  }
  double operator()(const Cone& cone) const {
    // The distance of the origin, half way up, from the slope and from the base.
    return std::min(cone.half_height, cone.radius * cone.half_height /
                                          std::hypot(cone.radius, 2 * cone.half_height));
  }
};

/** Returns the pose of A seen from B, along the axes of B or of the world. */
Pose Relative(const Body& A, const Body& B, bool along_axes_of_B) {
  const Eigen::Vector3d p_BA_W = A.X_WB.p_WB - B.X_WB.p_WB;
  if (!along_axes_of_B) return Pose::FromMatrix(p_BA_W, A.X_WB.R_WB);
  const Eigen::Matrix3d R_BW = B.X_WB.R_WB.transpose();
  return Pose::FromMatrix(R_BW * p_BA_W, R_BW * A.X_WB.R_WB);
}

double TurnBetween(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) {
  return Eigen::Quaterniond(from).angularDistance(Eigen::Quaterniond(to));
}

/** Returns a ball that moves from one point to another, as one body. */
Body SweptBall(double radius, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d way = to - from;
  const double half_length = way.norm() / 2;
  const Eigen::Vector3d middle = (from + to) / 2;
  if (half_length == 0)
    return {Sphere{radius}, Pose::FromQuaternion(middle, Eigen::Quaterniond::Identity())};
  return {Capsule{radius, half_length},
          Pose::FromQuaternion(
              middle, Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), way)
                          .normalized())};
}

/** Returns the volume that a shape sweeps from one pose to another; none if the shape has
 no ball about its origin to sweep. */
std::optional<Body> Sweep(const Shape& shape, const Pose& from, const Pose& to,
                          bool as_ball) {
  if (as_ball) {
    const double radius = std::visit(BallIn{}, shape);
    if (radius <= 0) return std::nullopt;
    return SweptBall(radius, from.p_WB, to.p_WB);
  }
  ConvexHull hull;
  for (const Eigen::Vector3d& point : std::visit(PointsOf{}, shape)) {
    hull.vertices.push_back(from * point);
    hull.vertices.push_back(to * point);
  }
  return Body{hull, Pose::FromQuaternion(Eigen::Vector3d::Zero(),
                                         Eigen::Quaterniond::Identity())};
}

}  // namespace

SweptOverlap SweptOverlapOf(const World& world, const WorldState& from,
                            const WorldState& to, int A, int B) {
  // A sphere sweeps a capsule exactly, whichever of the two moves.
  if (std::holds_alternative<Sphere>(
          world.bodies[static_cast<std::size_t>(B)].placed.shape))
    std::swap(A, B);
  const Body A_from = PlacedAt(world, from, A);
  const Body A_to = PlacedAt(world, to, A);
  const Body B_from = PlacedAt(world, from, B);
  const Body B_to = PlacedAt(world, to, B);
  double B_turn = TurnBetween(B_from.X_WB.R_WB, B_to.X_WB.R_WB);
  // A ball looks the same along all axes.
  const bool B_as_ball =
      std::holds_alternative<Sphere>(B_from.shape) || B_turn > kMostTurn;
  if (B_as_ball) B_turn = 0;
  const Pose start = Relative(A_from, B_from, !B_as_ball);
  const Pose end = Relative(A_to, B_to, !B_as_ball);
  const double A_turn = TurnBetween(start.R_WB, end.R_WB);
  const bool A_as_ball =
      std::holds_alternative<Sphere>(A_from.shape) || A_turn > kMostTurn;
  const double A_radius = A_as_ball ? 0 : BoundingRadius(A_from.shape);
  SweptOverlap swept;
  // The arc of a point at distance r that turns by an angle leaves its chord by at most
  // r angle²/8.
  const double p_AB = std::max(start.p_WB.norm(), end.p_WB.norm());
  swept.bend = (A_radius * A_turn * A_turn + p_AB * B_turn * B_turn) / 8;
  const std::optional<Body> volume = Sweep(A_from.shape, start, end, A_as_ball);
  const Pose origin =
      Pose::FromQuaternion(Eigen::Vector3d::Zero(), Eigen::Quaterniond::Identity());
  const double B_ball = std::visit(BallIn{}, B_from.shape);
  if (!volume || (B_as_ball && B_ball <= 0)) return swept;
  const Body other{B_as_ball ? Shape{Sphere{B_ball}} : B_from.shape, origin};
  swept.depth = std::max(0.0, -ComputeContactTruth({*volume, other}).separation.hi);
  return swept;
}

}  // namespace touchstone
