#include "reports/contacts/judge_variant.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "reports/contacts/grade.h"
#include "reports/contacts/normal_claim.h"
#include "reports/contacts/proof.h"
#include "reports/contacts/tolerances.h"
#include "reports/measures/answer_change.h"
#include "reports/measures/invalidity.h"
#include "reports/measures/outside.h"
#include "reports/measures/overlap_along.h"
#include "reports/measures/stated.h"
#include "reports/text/format_vector.h"
#include "reports/text/told_apart.h"
#include "scenarios/cube_rotations.h"
#include "scenarios/transformations.h"

namespace touchstone {
namespace {

/** The factor of the scaled variant: small, so that an engine's absolute tolerances show,
 and not a power of two, so that the digits change. [-] */
constexpr double kScale = 1 / 7.3;

/** The displacement of the perturbed variant relative to the scene: sixteen times the
 rounding of a float, so that float engines see it, and far smaller than any feature. [-]
 */
constexpr double kPerturbation = 0x1p-20;

/** Returns a direction along no axis. */
const Eigen::Vector3d& AwkwardDirection() {
  static const Eigen::Vector3d direction =
      Eigen::Vector3d(0.52831, -0.77123, 0.35507).normalized();
  return direction;
}

/** Returns the FNV-1a hash, so that the choice is the same on every machine. */
std::uint32_t HashOf(const std::string& id) {
  std::uint32_t hash = 2166136261U;
  for (const char c : id) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return hash;
}

/** Returns a motion by about a metre and a rotation about no coordinate axis. */
const Pose& AwkwardMotion() {
  static const Pose motion = Pose::FromQuaternion(
      {0.71, -0.43, 0.97}, Eigen::Quaterniond(0.31, 0.53, -0.59, 0.52).normalized());
  return motion;
}

bool IsBox(const Body& body) {
  return std::holds_alternative<Box>(body.shape);
}

ContactAnswer BroughtBack(const Variant& variant, const ContactAnswer& answer) {
  switch (variant.measure) {
    case MeasureKind::kSwap:
      return BackFromSwap(answer);
    case MeasureKind::kRigidMotion:
      return BackFromMotion(answer, Eigen::Translation3d(AwkwardMotion().p_WB) *
                                        Eigen::Isometry3d(AwkwardMotion().R_WB));
    case MeasureKind::kScaling:
      return BackFromScale(answer, variant.factor);
    default:
      return answer;
  }
}

/** Returns how the variant differs from the question. */
std::string ChangeOf(const ContactQuery& query, const Variant& variant) {
  switch (variant.measure) {
    case MeasureKind::kSwap:
      return "swap: A and B exchanged";
    case MeasureKind::kRigidMotion:
      return fmt::format(
          "rigid_motion: both turned by the quaternion ({:.6g}, {:.6g}, {:.6g}, {:.6g}) "
          "about the origin, then moved by {}",
          AwkwardMotion().q_WB->w(), AwkwardMotion().q_WB->x(), AwkwardMotion().q_WB->y(),
          AwkwardMotion().q_WB->z(), FormatVector(AwkwardMotion().p_WB));
    case MeasureKind::kScaling:
      return fmt::format("scaling: all lengths times {:.9g}", variant.factor);
    case MeasureKind::kPerturbation:
      return fmt::format("perturbation: B moved by {}",
                         FormatVector(variant.query.B.X_WB.p_WB - query.B.X_WB.p_WB));
    default:
      return "relabelling: the axes of its boxes renamed";
  }
}

/** Returns a signed separation as text: "0.05 m deep", "0.01 m apart". */
std::string DeepOrApart(std::string_view separation) {
  return separation.starts_with('-') ? fmt::format("{} m deep", separation.substr(1))
                                     : fmt::format("{} m apart", separation);
}

constexpr int kDigits = 9;

/** States the two separations and their difference, which a reader can check by
 subtraction. */
std::string ProveSeparations(const ContactTruth& truth, const ContactAnswer& answer,
                             const ContactAnswer& back, std::string_view change) {
  const auto first = SeparationOf(answer);
  const auto second = SeparationOf(back);
  if (first && second) {
    const auto [said, other, difference] = TellApart(*first, *second, kDigits);
    if (answer.touching == back.touching ||
        std::abs(*first - *second) >= Outside(0, truth.separation)) {
      return fmt::format(
          "says {}; for its variant ({}), mapped back, it says {}: a "
          "difference of {} m",
          DeepOrApart(said), change, DeepOrApart(other), difference);
    }
  }
  return fmt::format(
      "says {}; for its variant ({}) it says {}: the separation is "
      "certified to be {:.3g} m from touching",
      answer.touching ? "touching" : "apart", change,
      back.touching ? "touching" : "apart", Outside(0, truth.separation));
}

/** States the overlaps along the two normals, which a reader can compute, and their
 difference. */
std::string ProveOverlaps(const ContactQuery& query, const ContactAnswer& answer,
                          const ContactAnswer& back, std::string_view change) {
  const auto overlap = [&](const Eigen::Vector3d& n_W) {
    const Enclosure along = OverlapAlong(query, n_W);
    return along.lo + (along.hi - along.lo) / 2;
  };
  const Eigen::Vector3d n_W = NormalOf(answer).value();
  const Eigen::Vector3d back_W = NormalOf(back).value();
  const auto [first, second, difference] =
      TellApart(overlap(n_W), overlap(back_W), kDigits);
  return fmt::format(
      "says n = {}, along which max_A n·x − min_B n·x is {} m; for its variant ({}), "
      "mapped back, it says n = {}, along which that is {} m: a difference of {} m",
      FormatVector(n_W), first, change, FormatVector(back_W), second, difference);
}

/** Returns the name of a field that `answer` states and `back` does not; "" if there is
 none.
 @param promised Whether the oracle returns distances for separated pairs. */
std::string_view MissingOf(const ContactAnswer& answer, const ContactAnswer& back,
                           bool promised) {
  if (answer.touching != back.touching || !(answer.touching || promised)) return "";
  if (SeparationOf(answer) && !SeparationOf(back)) return "separation";
  return NormalOf(answer) && !NormalOf(back) ? "normal" : "";
}

void ForgetNormals(ContactAnswer& answer) {
  answer.n_AB_W.reset();
  for (ContactPoint& contact : answer.points) contact.n_AB_W.reset();
}

/** The differences granted between an answer and the mapped-back answer to a variant. */
struct Granted {
  Tolerance separation;
  Tolerance overlap;
};

/** Returns the granted differences. Both separations may be off, and their errors add up.
 Both overlaps lie between the least overlap, which is the same for both, and the granted
 excess above it: they differ by no more than the larger excess. */
Granted GrantedBetween(const Scenario& scenario, const ContactTruth& truth,
                       const OracleInfo& oracle, const Variant& variant, bool touching,
                       bool variant_touching) {
  const double f = variant.factor;
  Scenario changed = scenario;
  changed.contact = variant.query;
  ContactTruth changed_truth = truth;
  changed_truth.separation = {truth.separation.lo * f, truth.separation.hi * f};
  changed_truth.input_rounding = truth.input_rounding * f + variant.rounding;
  const Tolerances base = TolerancesOf(oracle, scenario, truth, touching);
  const Tolerances other = TolerancesOf(oracle, changed, changed_truth, variant_touching);
  return {{base.separation.value + other.separation.value / f,
           fmt::format("both answers may be off, the first by {:.2g} m ({}), the second "
                       "by {:.2g} m on its own scene",
                       base.separation.value, base.separation.because,
                       other.separation.value)},
          {std::max(base.excess.value, other.excess.value / f),
           fmt::format("both normals may be longer than the shortest, the first by "
                       "{:.2g} m ({}), the second by {:.2g} m on its own scene",
                       base.excess.value, base.excess.because, other.excess.value)}};
}

}  // namespace

std::vector<Variant> VariantsOf(const Scenario& scenario) {
  const ContactQuery& query = scenario.contact;
  std::vector<Variant> variants;
  const auto add = [&](MeasureKind measure, const TransformedQuery& transformed,
                       double factor, double play) {
    variants.push_back({measure, transformed.query, factor, transformed.rounding, play});
  };
  add(MeasureKind::kSwap, Swapped(query), 1, 0);
  add(MeasureKind::kRigidMotion, MovedRigidly(query, AwkwardMotion()), 1, 0);
  add(MeasureKind::kScaling, Scaled(query, kScale), kScale, 0);
  if (IsBox(query.A) || IsBox(query.B)) {
    // Symmetry 0 is the identity.
    const int symmetry = 1 + static_cast<int>(HashOf(scenario.id) % (kCubeRotations - 1));
    add(MeasureKind::kRelabelling, Relabelled(query, symmetry, kCubeRotations - symmetry),
        1, 0);
  }
  const double shift = kPerturbation * SceneSize(query);
  // The depth moves by at most the shift, and so does the overlap along a fixed
  // direction. The overlap along the direction that is best for the moved B moves by at
  // most both together.
  add(MeasureKind::kPerturbation, Perturbed(query, shift * AwkwardDirection()), 1,
      2 * shift);
  return variants;
}

std::optional<Finding> JudgeVariant(const Scenario& scenario, const ContactTruth& truth,
                                    const OracleInfo& oracle, const ContactAnswer& answer,
                                    const Variant& variant,
                                    const ContactAnswer& variant_answer) {
  const Granted granted = GrantedBetween(scenario, truth, oracle, variant,
                                         answer.touching, variant_answer.touching);
  Finding finding;
  finding.scenario = scenario.id;
  finding.oracle = oracle.name;
  finding.measure = variant.measure;
  finding.tolerance = granted.separation.value;
  finding.tolerance_because = granted.separation.because;
  const auto failed = [&](Verdict verdict, const std::string& why) {
    finding.verdict = verdict;
    finding.proof = fmt::format("{} answers the question, but not its variant ({}): {}{}",
                                oracle.name, ChangeOf(scenario.contact, variant), why,
                                why.ends_with('.') ? "" : ".");
    return finding;
  };
  if (variant_answer.status == AnswerStatus::kCrashed) {
    return failed(Verdict::kCrashed, variant_answer.reason);
  }
  if (variant_answer.status == AnswerStatus::kTimedOut) {
    return failed(Verdict::kTimedOut, variant_answer.reason);
  }
  if (variant_answer.status == AnswerStatus::kUnsupported) {
    return failed(Verdict::kUnsupported, variant_answer.reason);
  }
  const double unit_slack =
      TolerancesOf(oracle, scenario, truth, answer.touching).unit_normal;
  if (const auto fault = InvalidityOf(variant_answer, unit_slack)) {
    return failed(Verdict::kInvalid, *fault);
  }
  const ContactQuery& query = scenario.contact;
  ContactAnswer back = BroughtBack(variant, variant_answer);
  const bool near =
      Outside(0, truth.separation) <= granted.separation.value + variant.play;
  // If the bodies are apart, any separating direction is legal, unless the oracle
  // promises distances.
  const Capability& capability = oracle.For(KindOf(query.A.shape), KindOf(query.B.shape));
  // An engine that derives the normal from two witness points has none where they
  // coincide.
  const std::string_view missing =
      near ? "" : MissingOf(answer, back, capability.distance);
  if (!missing.empty()) {
    return failed(Verdict::kInvalid, fmt::format("it returns no {}", missing));
  }
  if (!ClaimsLeastDirection(truth, capability, answer)) {
    ForgetNormals(back);
  }
  const AnswerDifference change = AnswerChange(query, truth, answer, back);
  if (near && !change.compared) return std::nullopt;
  const double separation = std::max(0.0, change.separation - variant.play);
  const double overlap = std::max(0.0, change.overlap - variant.play);
  // The finding reports whichever of the two is further beyond its tolerance.
  finding.value = separation;
  const bool by_overlap =
      overlap * granted.separation.value > separation * granted.overlap.value;
  if (by_overlap) {
    finding.value = overlap;
    finding.tolerance = granted.overlap.value;
    finding.tolerance_because = granted.overlap.because;
  }
  // Written so that a NaN fails.
  finding.verdict = finding.value <= finding.tolerance ? Verdict::kPass : Verdict::kFail;
  if (!std::isfinite(finding.tolerance)) finding.verdict = Verdict::kUndecidable;
  const double fine = TolerancesOf(oracle, scenario, truth, answer.touching).fine;
  if (finding.verdict == Verdict::kPass && finding.tolerance > fine) {
    if (finding.value <= fine) {
      finding.tolerance = fine;
    } else {
      finding.verdict = Verdict::kUndecidable;
      finding.undecided = Undecided::kCoarse;
    }
  }
  if (finding.verdict == Verdict::kFail) {
    finding.grade = GradeOf(finding, query, truth);
    finding.safety = kRoundingsSafety;
    const std::string changed = ChangeOf(query, variant);
    finding.proof =
        fmt::format("{} {}", oracle.name,
                    by_overlap ? ProveOverlaps(query, answer, back, changed)
                               : ProveSeparations(truth, answer, back, changed));
    // The value of the finding excludes the change that the variant itself explains.
    if (variant.play > 0) {
      finding.proof += fmt::format(
          ", of which the motion itself explains up to {:.3g} m, and {:.3g} m are left",
          variant.play, finding.value);
    }
    finding.proof += '.';
    if (variant.measure == MeasureKind::kSwap && NormalOf(back)) {
      const AnswerDifference left = AnswerChange(query, truth, answer, variant_answer);
      if (left.separation <= granted.separation.value &&
          left.overlap <= granted.overlap.value) {
        finding.cause = Cause::kConvention;
        finding.cause_because = "its normal does not turn when A and B are swapped";
      }
    }
  }
  return finding;
}

}  // namespace touchstone
