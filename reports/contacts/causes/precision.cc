#include "reports/contacts/causes/precision.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "reports/measures/answer_change.h"
#include "reports/measures/outside.h"

namespace touchstone {
namespace {

/** The distance of a neighbour in roundings: more than storing it costs, less than the
 kRoundings that a correct computation may accumulate. [-] */
constexpr double kAway = 4;

constexpr double kDouble = 0x1p-53;

// Never inlined: g++ 12 at -O2 vectorises pairs of (double)(float)x and drops the
// conversion.
[[gnu::noinline]] double RoundedToFloat(double number) {
  return static_cast<float>(number);
}

template <typename Derived>
void RoundToFloat(Eigen::MatrixBase<Derived>& numbers) {
  numbers = numbers.unaryExpr(&RoundedToFloat).eval();
}

struct RoundShape {
  void operator()(Sphere& sphere) const { sphere.radius = RoundedToFloat(sphere.radius); }
  void operator()(Box& box) const { RoundToFloat(box.half_extents); }
  void operator()(Capsule& capsule) const {
    capsule.radius = RoundedToFloat(capsule.radius);
    capsule.half_length = RoundedToFloat(capsule.half_length);
  }
  void operator()(Cylinder& cylinder) const {
    cylinder.radius = RoundedToFloat(cylinder.radius);
    cylinder.half_length = RoundedToFloat(cylinder.half_length);
  }
  void operator()(Cone& cone) const {
    cone.radius = RoundedToFloat(cone.radius);
    cone.half_height = RoundedToFloat(cone.half_height);
  }
  void operator()(ConvexHull& hull) const {
    for (Eigen::Vector3d& v : hull.vertices) RoundToFloat(v);
  }
  void operator()(HalfSpace&) const {}
};

Body Rounded(Body body) {
  std::visit(RoundShape{}, body.shape);
  Eigen::Vector3d p = body.X_WB.p_WB;
  Eigen::Matrix3d R = body.X_WB.R_WB;
  RoundToFloat(p);
  RoundToFloat(R);
  body.X_WB = Pose::FromMatrix(p, R);
  return body;
}

}  // namespace

std::vector<ContactQuery> NeighboursOf(const ContactQuery& query, double u) {
  std::vector<ContactQuery> neighbours;
  const double shift = kAway * u * SceneSize(query);
  const Pose& X_WB = query.B.X_WB;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      const Eigen::Vector3d unit = sign * Eigen::Vector3d::Unit(axis);
      ContactQuery moved = query;
      moved.B.X_WB = Pose::FromMatrix(X_WB.p_WB + shift * unit, X_WB.R_WB);
      neighbours.push_back(moved);
      ContactQuery turned = query;
      const Eigen::Matrix3d turn = Eigen::AngleAxisd(kAway * u, unit).toRotationMatrix();
      turned.B.X_WB = Pose::FromMatrix(X_WB.p_WB, turn * X_WB.R_WB);
      neighbours.push_back(turned);
    }
  }
  if (u > kDouble) neighbours.push_back({Rounded(query.A), Rounded(query.B)});
  return neighbours;
}

double MovementOf(const ContactQuery& query, const ContactTruth& truth,
                  const ContactAnswer& answer,
                  std::span<const ContactAnswer> neighbours) {
  double movement = 0;
  for (const ContactAnswer& neighbour : neighbours) {
    if (neighbour.status != AnswerStatus::kAnswered) continue;
    // A neighbour without a usable normal or separation gives no distance.
    if (neighbour.n_AB_W && !(neighbour.n_AB_W->norm() > 0)) continue;
    if (neighbour.separation && !std::isfinite(*neighbour.separation)) continue;
    movement =
        std::max(movement, AnswerChange(query, truth, answer, neighbour).Largest());
  }
  return movement;
}

std::optional<std::string> PrecisionOf(const Finding& finding, const ContactTruth& truth,
                                       double movement, double u) {
  double error = 0;
  if (finding.measure == MeasureKind::kTouching) {
    error = Outside(0, truth.separation);
  } else if (UnitOf(finding.measure) == "m") {
    error = finding.value;
  } else {
    return std::nullopt;
  }
  // An error without a size, in a scene that is exactly flush, has no rounding to
  // explain.
  if (!(error > 0) || !(movement >= kExplains * error)) return std::nullopt;
  return fmt::format(
      "{:.0f} roundings of 2^{:.0f} on its input move its answer by {:.3g} m", kAway,
      std::log2(u), movement);
}

}  // namespace touchstone
