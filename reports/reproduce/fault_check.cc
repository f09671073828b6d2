#include "reports/reproduce/fault_check.h"

#include <cmath>

#include <fmt/format.h>

#include "reports/reproduce/contact_check.h"
#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/engine_code.h"
#include "reports/reproduce/fault_subject.h"
#include "reports/reproduce/patch_check.h"

namespace touchstone {
namespace {

/** Writes max over the body of d·x, less d·p, from the components x, y and z of d along
 the body's axes. */
struct Reach {
  std::string operator()(const Sphere& s) const {
    return fmt::format("  return {} * std::sqrt(x * x + y * y + z * z);\n",
                       Literal(s.radius));
  }
  std::string operator()(const Box& s) const {
    return fmt::format(
        "  return {} * std::abs(x) + {} * std::abs(y) + {} * std::abs(z);\n",
        Literal(s.half_extents.x()), Literal(s.half_extents.y()),
        Literal(s.half_extents.z()));
  }
  std::string operator()(const Capsule& s) const {
    return fmt::format(
        "  return {} * std::sqrt(x * x + y * y + z * z) + {} * std::abs(z);\n",
        Literal(s.radius), Literal(s.half_length));
  }
  std::string operator()(const Cylinder& s) const {
    return fmt::format("  return {} * std::hypot(x, y) + {} * std::abs(z);\n",
                       Literal(s.radius), Literal(s.half_length));
  }
  std::string operator()(const Cone& s) const {
    return fmt::format("  return std::max({1} * z, {0} * std::hypot(x, y) - {1} * z);\n",
                       Literal(s.radius), Literal(s.half_height));
  }
  std::string operator()(const ConvexHull& s) const {
    std::string vertices;
    for (const Eigen::Vector3d& vertex : s.vertices)
      vertices += fmt::format("\n      {{{}}},", Literals(vertex));
    return fmt::format(
        "  static const double vertices[][3] = {{{}}};\n  double most = -INFINITY;\n"
        "  for (const auto& v : vertices)\n"
        "    most = std::max(most, v[0] * x + v[1] * y + v[2] * z);\n  return most;\n",
        vertices);
  }
  std::string operator()(const HalfSpace&) const {
    throw CannotReproduce(
        "a half-space has no reach along a normal: only the measures "
        "touching and separation_error can be checked with one");
  }
};

std::string ReachText(char name, const Body& body) {
  const Eigen::Vector3d& p = body.X_WB.p_WB;
  const Eigen::Matrix3d& R = body.X_WB.R_WB;
  const auto column = [&](int i) {
    return fmt::format("{} * d[0] + {} * d[1] + {} * d[2]", Literal(R(0, i)),
                       Literal(R(1, i)), Literal(R(2, i)));
  };
  return fmt::format(
      "\n// The components of d along the axes of {0}, and how far {0} reaches along "
      "them.\n"
      "double Around{0}(double x, double y, double z) {{\n{1}}}\n"
      "double Reach{0}(const Vector& d) {{\n"
      "  return {2} * d[0] + {3} * d[1] + {4} * d[2] +\n"
      "         Around{0}({5},\n                 {6},\n                 {7});\n}}\n",
      name, std::visit(Reach{}, body.shape), Literal(p.x()), Literal(p.y()),
      Literal(p.z()), column(0), column(1), column(2));
}

std::string Overlap(const ContactQuery& query) {
  return ReachText('A', query.A) + ReachText('B', query.B) + R"(
// The overlap of A and B along the unit vector n: moving B that far along n just separates
// them. Negative: the gap.
double Overlap(const Vector& n) {
  return ReachA(n) + ReachB({-n[0], -n[1], -n[2]});
}
)";
}

std::string Truth(const ContactTruth& truth) {
  return fmt::format(
      "  // The true separation is certified to lie between these two.\n"
      "  const double lo = {};\n  const double hi = {};\n"
      "  std::printf(\"truth: separation in [%.17g, %.17g] (negative: overlap)\\n\", lo, "
      "hi);\n",
      Literal(truth.separation.lo), Literal(truth.separation.hi));
}

/** Returns `check` for answers that have a separation. */
FaultCheck OfSeparations(FaultCheck check) {
  check.applies = "!std::isnan(answer.separation)";
  check.applies_to = "how deep or how far apart they are";
  return check;
}

/** Prints the truth, and sets `along` to the overlap along the normal of the answer. */
std::string OverlapAlongNormal(const ContactTruth& truth) {
  return Truth(truth) +
         "  const double along = Overlap(answer.n);\n"
         "  std::printf(\"overlap along its own normal: %.17g\\n\", along);\n";
}

/** A normal of this accuracy is one of unit length, also in single precision. [-] */
constexpr double kUnitSlack = 1e-6;

/** The check of an answer that is invalid. */
FaultCheck InvalidityCheck(const ContactAnswer& answer) {
  if (answer.separation && !std::isfinite(*answer.separation)) {
    return OfAnswersLike(answer, "",
                         "  const double error = std::isfinite(answer.separation) ? 0 : "
                         "std::numeric_limits<double>::infinity();\n");
  }
  if (!answer.n_AB_W || std::abs(answer.n_AB_W->norm() - 1) <= kUnitSlack) {
    throw CannotReproduce(fmt::format(
        "of an invalid answer, a program checks that the separation is finite and that "
        "the normal has length 1 to {}",
        kUnitSlack));
  }
  return OfAnswersLike(
      answer, "",
      fmt::format(
          "  const double length = std::hypot(answer.n[0], answer.n[1], answer.n[2]);\n"
          "  std::printf(\"length of the normal: %.17g\\n\", length);\n"
          "  const double deviation = std::abs(length - 1);\n"
          "  const double error = deviation <= {} ? 0 : deviation;\n",
          kUnitSlack));
}

}  // namespace

bool IsWithoutAnswer(const Finding& finding) {
  return finding.measure == MeasureKind::kAnswering &&
         (finding.verdict == Verdict::kCrashed || finding.verdict == Verdict::kTimedOut);
}

FaultCheck CheckOf(const Finding& finding, const ScenarioResult& result,
                   const OracleInfo& oracle) {
  const ContactAnswer none;
  const ContactAnswer& answer = result.answers.empty() ? none : result.answers.front();
  if (finding.measure == MeasureKind::kAnswering && finding.verdict == Verdict::kInvalid)
    return InvalidityCheck(answer);
  if (finding.verdict != Verdict::kFail) {
    throw CannotReproduce(fmt::format(
        "the verdict of {} is '{}'; expected a wrong answer, or one that is missing",
        NameOf(finding.measure), NameOf(finding.verdict)));
  }
  const ContactQuery& query = result.scenario.contact;
  const ContactTruth& truth = result.truth;
  const FaultSubject subject{finding, result.scenario, truth, answer, oracle};
  switch (finding.measure) {
    case MeasureKind::kTouching:
      return {.definitions = "",
              .statements =
                  Truth(truth) +
                  fmt::format("  const double error = answer.touching == {} ? 0 : 1;\n",
                              truth.separation.lo > 0 ? "false" : "true")};
    case MeasureKind::kSeparationError:
      return OfSeparations({.definitions = "",
                            .statements = Truth(truth) +
                                          "  const double s = answer.separation;\n"
                                          "  const double error = std::max({0.0, lo - s, "
                                          "s - hi});\n"});
    case MeasureKind::kConsistencyError:
      return OfSeparations(
          {.definitions = Overlap(query),
           .statements =
               OverlapAlongNormal(truth) +
               "  const double error = std::abs(-answer.separation - along);\n"});
    case MeasureKind::kExcess:
      return OfAnswersLike(
          answer, Overlap(query),
          OverlapAlongNormal(truth) + "  const double error = along + lo;\n");
    case MeasureKind::kDualityGap:
      return OfNearestPoints(OfAnswersLike(
          answer, Overlap(query),
          Truth(truth) +
              "  Vector n;\n"
              "  for (int i = 0; i < 3; ++i) n[i] = answer.b[i] - answer.a[i];\n"
              "  const double length = std::hypot(n[0], n[1], n[2]);\n"
              "  for (double& x : n) x /= length;\n"
              "  const double gap = -Overlap(n);\n"
              "  std::printf(\"distance of its points: %.17g, gap along them: "
              "%.17g\\n\", length, gap);\n"
              "  const double error = std::abs(length - gap);\n"));
    case MeasureKind::kContactSurfaceError:
      return SurfaceErrorCheck(subject);
    case MeasureKind::kContactSeparationError:
      return ContactSeparationCheck(subject);
    case MeasureKind::kContactTooDeep:
      return TooDeepCheck(subject);
    case MeasureKind::kContactOffPatch:
      return OffPatchCheck(subject);
    case MeasureKind::kPatchCoverage:
      return CoverageCheck(subject);
    case MeasureKind::kContactCount:
      return CountCheck(subject);
    case MeasureKind::kMixedNormals:
      return MixedNormalsCheck(subject);
    case MeasureKind::kWitnessError:
      return WitnessErrorCheck(subject);
    default:
      throw CannotCheck(fmt::format(
          "a program cannot check {}; it can check touching, separation_error, "
          "consistency_error, excess, duality_gap, witness_error, contact_surface_error, "
          "contact_separation_error, contact_too_deep, contact_off_patch, "
          "patch_coverage, contact_count and mixed_normals",
          NameOf(finding.measure)));
  }
}

}  // namespace touchstone
