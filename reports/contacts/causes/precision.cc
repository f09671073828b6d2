#include "reports/contacts/causes/precision.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "reports/contacts/body_size.h"
#include "reports/contacts/judge_answer.h"
#include "reports/finding/grade.h"
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

/** Returns the distance between two enclosures; 0 if they meet. [m] */
double GapOf(const Enclosure& a, const Enclosure& b) {
  return std::max({0.0, a.lo - b.hi, b.lo - a.hi});
}

/** Returns whether the answer that a finding is about has a fault. */
bool HasFailed(const Finding& finding) {
  return IsFailure(finding.verdict);
}

bool IsByReferee(const Finding& finding) {
  return finding.reference == "referee";
}

/** Returns whether an answer that is right for a question is right, to a few roundings,
 for one that is moved by roundings. Separations, excess and overlaps at points change no
 more than the bodies move. A patch jumps where faces become flush. So may an answer that
 is compared with another: at a tie, two normals are equally right. */
bool IsStable(const Finding& finding) {
  const bool has_length =
      finding.measure == MeasureKind::kTouching || UnitOf(finding.measure) == "m";
  return IsByReferee(finding) && has_length &&
         finding.measure != MeasureKind::kContactOffPatch;
}

/** Returns the measures of a neighbour's answer that decide whether rounding explains the
 failures that have no cause yet; empty: all of them, since an answer that is compared
 with another must not fail at all. */
std::vector<MeasureKind> WantedFor(std::span<const Finding> findings) {
  std::vector<MeasureKind> wanted;
  for (const Finding& finding : findings) {
    if (!IsProvedWrong(finding) || finding.cause != Cause::kNone) continue;
    if (!IsByReferee(finding)) return {};
    wanted.push_back(finding.measure);
  }
  return wanted;
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

std::vector<JudgedNeighbour> Judged(const Scenario& scenario, const OracleInfo& oracle,
                                    std::span<const ContactQuery> queries,
                                    std::span<const ContactTruth> truths,
                                    std::span<const ContactAnswer> answers,
                                    std::span<const Finding> findings) {
  const std::vector<MeasureKind> wanted = WantedFor(findings);
  std::vector<JudgedNeighbour> judged;
  Scenario moved = scenario;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    if (answers[i].status != AnswerStatus::kAnswered) continue;
    moved.contact = queries[i];
    judged.push_back(
        {truths[i], answers[i],
         JudgeAnswer(moved, truths[i], oracle, answers[i], Reasons::kNone, wanted)});
  }
  return judged;
}

std::optional<Explanation> ExplanationByRounding(
    const Finding& finding, const ContactQuery& query, const ContactTruth& truth,
    const ContactAnswer& answer, std::span<const JudgedNeighbour> neighbours, double u) {
  const bool by_referee = IsByReferee(finding);
  double error = std::numeric_limits<double>::infinity();
  if (finding.measure == MeasureKind::kTouching) {
    error = Outside(0, truth.separation);
  } else if (UnitOf(finding.measure) == "m") {
    error = finding.value;
  }
  // An error without a size, in a scene that is exactly flush, has no rounding to
  // explain.
  if (!(error > 0)) return std::nullopt;
  const auto is_pass = [&](const Finding& other) {
    return other.measure == finding.measure && other.verdict == Verdict::kPass;
  };
  double truth_moves = 0;
  double answer_moves = 0;
  bool is_right_nearby = false;
  for (const JudgedNeighbour& neighbour : neighbours) {
    truth_moves =
        std::max(truth_moves, GapOf(truth.separation, neighbour.truth.separation));
    const std::vector<Finding>& findings = neighbour.findings;
    is_right_nearby = is_right_nearby || std::ranges::any_of(findings, is_pass);
    if (std::none_of(findings.begin(), findings.end(), HasFailed))
      answer_moves = std::max(
          answer_moves, AnswerChange(query, truth, answer, neighbour.answer).Largest());
  }
  const std::string roundings =
      fmt::format("{:.0f} roundings of 2^{:.0f}", kAway, std::log2(u));
  if (truth_moves >= kExplains * error) {
    return Explanation{
        Cause::kPrecision,
        fmt::format("{} on the input move the truth by {:.3g} m", roundings, truth_moves),
        true};
  }
  const bool moves = by_referee ? is_right_nearby : answer_moves >= kExplains * error;
  if (!moves) return std::nullopt;
  const double share = error / SmallerExtent(query);
  if (IsStable(finding) && GradeOfShare(share) == Grade::kGross) {
    return Explanation{
        Cause::kDefect,
        fmt::format("{} on its input make its answer right, but move the truth by {:.3g} "
                    "m only: rounding decides that it errs, not that it errs by {:.3g} m",
                    roundings, truth_moves, error)};
  }
  if (by_referee) {
    return Explanation{Cause::kPrecision,
                       fmt::format("{} on its input make its answer right", roundings)};
  }
  return Explanation{
      Cause::kPrecision,
      fmt::format("{} on its input move its answer by {:.3g} m, to a right one",
                  roundings, answer_moves)};
}

}  // namespace touchstone
