#include "reports/worlds/law_support/swept.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "reports/referee/referee.h"
#include "reports/worlds/law_support/overlap.h"

namespace touchstone {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/** Number of points on each circle of a curved shape. */
constexpr int kPointsOfCircle = 12;

/** The largest turn at which the hull of a shape before and after it says whether the
 shape may meet another on the way. [rad] */
constexpr double kSmallTurn = 1;

/** The largest turn of A seen from B that is known to be the shorter way round. [rad] */
constexpr double kHalfRound = 3;

/** The largest turn that a piece of the way leaves out, to either side: it grants less
 than 1 % of the body's radius. [rad] */
constexpr double kFineTurn = 1.0 / 128;

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

/** Returns a ball that moves from one point to another, as one body. @pre They differ. */
Body SweptBall(double radius, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d way = to - from;
  return {Capsule{radius, way.norm() / 2},
          Pose::FromQuaternion((from + to) / 2, Eigen::Quaterniond::FromTwoVectors(
                                                    Eigen::Vector3d::UnitZ(), way)
                                                    .normalized())};
}

/** Returns the hull of a shape at two poses. */
Body HullAt(const Shape& shape, const Pose& from, const Pose& to) {
  ConvexHull hull;
  for (const Eigen::Vector3d& point : std::visit(PointsOf{}, shape)) {
    hull.vertices.push_back(from * point);
    hull.vertices.push_back(to * point);
  }
  return Body{hull, Pose{}};
}

double DepthOf(const Body& volume, const Body& other) {
  if (AreProvedApart({volume, other})) return 0;
  return std::max(0.0, -ComputeContactTruth({volume, other}).separation.hi);
}

bool IsPolytope(const Shape& shape) {
  return std::holds_alternative<Box>(shape) || std::holds_alternative<ConvexHull>(shape);
}

bool AreApart(const Body& volume, const Body& other) {
  return ComputeContactTruth({volume, other}).separation.lo >= 0;
}

/** The way of A as seen from B. */
struct Way {
  Pose start;
  Pose end;
  Shape shape;  ///< Of A.
  Body other;   ///< B, or a ball in it, at the origin.

  /** Returns the place of A at the share `s` of the way, with the turn at `turned`. */
  Pose At(double s, double turned) const {
    const Eigen::Quaterniond from(start.R_WB);
    return Pose::FromQuaternion(
        start.p_WB + s * (end.p_WB - start.p_WB),
        from.slerp(turned, Eigen::Quaterniond(end.R_WB)).normalized());
  }

  /** Returns the depth of the ball in A: that of a way around the other if the ball is
   certainly apart from it before and behind the way, 0 if it meets nothing. */
  double DepthOfBall() const {
    const double radius = std::visit(BallIn{}, shape);
    const Eigen::Vector3d way = end.p_WB - start.p_WB;
    if (radius <= 0 || way.isZero(0)) return 0;
    const double depth = DepthOf(SweptBall(radius, start.p_WB, end.p_WB), other);
    if (depth == 0) return 0;
    // So far that a way around is shorter than a way back.
    const Eigen::Vector3d beyond =
        2 * (radius + BoundingRadius(other.shape)) * way.normalized();
    const Eigen::Vector3d before = start.p_WB - beyond;
    const Eigen::Vector3d behind = end.p_WB + beyond;
    // A body at rest on another slides along it to within a rounding.
    if (!AreApart(SweptBall(radius, before, start.p_WB), other) ||
        !AreApart(SweptBall(radius, end.p_WB, behind), other)) {
      return depth;
    }
    return DepthOf(SweptBall(radius, before, behind), other);
  }

  /** Returns the greatest depth of `pieces` pieces of the way. */
  double DepthInPieces(int pieces) const {
    double depth = 0;
    for (int i = 0; i < pieces; ++i) {
      const double middle = (i + 0.5) / pieces;
      const double half = 0.5 / pieces;
      depth = std::max(depth, DepthOf(HullAt(shape, At(middle - half, middle),
                                             At(middle + half, middle)),
                                      other));
    }
    return depth;
  }
};

}  // namespace

std::vector<SweptOverlap> SweptOverlapsOf(const World& world, const WorldState& from,
                                          const WorldState& to, int A, int B,
                                          const Turns& turns) {
  // A sphere sweeps a capsule exactly, whichever of the two moves.
  if (std::holds_alternative<Sphere>(
          world.bodies[static_cast<std::size_t>(B)].placed.shape) &&
      !std::holds_alternative<Sphere>(
          world.bodies[static_cast<std::size_t>(A)].placed.shape)) {
    std::vector<SweptOverlap> overlaps =
        SweptOverlapsOf(world, from, to, B, A, {turns.B, turns.A, turns.followed});
    for (SweptOverlap& overlap : overlaps) std::swap(overlap.lever_A, overlap.lever_B);
    return overlaps;
  }
  const Body A_from = PlacedAt(world, from, A);
  const Body B_from = PlacedAt(world, from, B);
  const bool has_ball = std::holds_alternative<Sphere>(A_from.shape);
  // A ball looks the same along all axes.
  const bool B_as_ball =
      std::holds_alternative<Sphere>(B_from.shape) || turns.B > turns.followed;
  const double B_ball = std::visit(BallIn{}, B_from.shape);
  if (B_as_ball && B_ball <= 0) return {{}};
  const Body A_to = PlacedAt(world, to, A);
  const Body B_to = PlacedAt(world, to, B);
  const auto way_past = [&](const Shape& other, bool along_axes_of_B) {
    return Way{Relative(A_from, B_from, along_axes_of_B),
               Relative(A_to, B_to, along_axes_of_B),
               A_from.shape,
               {other, Pose{}}};
  };
  const Way way = way_past(B_as_ball ? Shape{Sphere{B_ball}} : B_from.shape, !B_as_ball);
  const double p_AB = std::max(way.start.p_WB.norm(), way.end.p_WB.norm());
  const double B_turn = B_as_ball ? 0 : turns.B;
  // Along B's axes a place at distance r that moves by d and turns by θ is accelerated by
  // at most r θ² + 2 θ d, per square of the time. A path leaves its chord by an eighth of
  // its acceleration.
  const double way_length =
      ((A_to.X_WB.p_WB - B_to.X_WB.p_WB) - (A_from.X_WB.p_WB - B_from.X_WB.p_WB)).norm();
  const SweptOverlap of_ball{
      .depth = way.DepthOfBall(),
      .bend = (p_AB * B_turn * B_turn + 2 * B_turn * way_length) / 8,
      .lever_B = B_as_ball ? 0 : p_AB};
  std::vector<SweptOverlap> overlaps = {of_ball};
  // Two balls pass each other whatever both turn.
  if (B_turn > 0 && B_ball > 0)
    overlaps.push_back({.depth = way_past(Sphere{B_ball}, false).DepthOfBall()});
  const double turn = turns.A + B_turn;
  if (has_ball || turns.A > turns.followed || turn > kHalfRound || B_as_ball)
    return overlaps;
  const bool is_apart = turn <= kSmallTurn &&
                        DepthOf(HullAt(way.shape, way.start, way.end), way.other) == 0;
  // The hull of points on a curved surface is smaller than the shape.
  if (is_apart && of_ball.depth == 0 && IsPolytope(way.shape)) return {};
  if (is_apart) return overlaps;
  const double radius = BoundingRadius(way.shape);
  const int pieces = std::max(1, static_cast<int>(std::ceil(turn / (2 * kFineTurn))));
  // Along B's axes the axis of A's turn turns with B.
  overlaps.push_back(
      {.depth = way.DepthInPieces(pieces),
       .bend = radius * turn / (2 * pieces) + radius * turn * B_turn / 8 + of_ball.bend,
       .lever_A = radius,
       .lever_B = radius + p_AB});
  return overlaps;
}

}  // namespace touchstone
