#include "reports/contacts/causes/precision.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "reports/contacts/causes/unexplained.h"
#include "reports/contacts/judge_answer.h"
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

/** Returns whether the measured length changes no faster than the bodies move. The patch
 jumps where faces become flush, and with it the contacts that it needs. */
bool IsContinuous(const Finding& finding) {
  const bool has_length =
      finding.measure == MeasureKind::kTouching || UnitOf(finding.measure) == "m";
  return has_length && finding.measure != MeasureKind::kContactOffPatch;
}

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

bool RoundingMayExplain(const Finding& finding, const ContactQuery& query,
                        const ContactTruth& truth, double u) {
  if (!IsUnexplained(finding) || finding.reference != "referee") return false;
  // Shifted by kAway roundings, or turned by as many about its own origin.
  const double farthest = 2 * kAway * u * SceneSize(query);
  return !IsContinuous(finding) || Outside(0, truth.separation) <= farthest;
}

void ExplainByRounding(const Scenario& scenario, const OracleInfo& oracle,
                       const ContactAnswer& answer,
                       std::span<const ContactQuery> neighbours,
                       std::span<const ContactTruth> truths,
                       std::span<Finding> findings) {
  Scenario moved = scenario;
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    moved.contact = neighbours[i];
    const std::vector<Finding> there =
        JudgeAnswer(moved, truths[i], oracle, answer, Reasons::kNone);
    if (std::ranges::any_of(there, &IsProvedWrong)) continue;
    for (Finding& finding : findings) {
      if (!IsUnexplained(finding)) continue;
      const bool passes = std::ranges::any_of(there, [&](const Finding& other) {
        return other.measure == finding.measure && other.verdict == Verdict::kPass;
      });
      if (!passes) continue;
      finding.cause = Cause::kPrecision;
      finding.cause_because = fmt::format(
          "the answer is right for an input that differs by {:.0f} roundings "
          "of 2^{:.0f}",
          kAway, std::log2(oracle.unit_roundoff));
    }
  }
}

}  // namespace touchstone
