#include "reports/contacts/judge_variant.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "reports/contacts/grade.h"
#include "reports/contacts/normal_claim.h"
#include "reports/contacts/tolerance_reasons.h"
#include "reports/contacts/tolerances.h"
#include "reports/measures/answer_change.h"
#include "reports/measures/invalidity.h"
#include "reports/measures/outside.h"
#include "reports/measures/overlap_along.h"
#include "reports/measures/stated.h"
#include "reports/text/format_vector.h"
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

/** States the two separations, whose difference a reader can check by subtraction. */
Proof ProveSeparations(const ContactTruth& truth, const ContactAnswer& answer,
                       const ContactAnswer& back) {
  const auto first = SeparationOf(answer);
  const auto second = SeparationOf(back);
  if (first && second &&
      (answer.touching == back.touching ||
       std::abs(*first - *second) >= Outside(0, truth.separation))) {
    return {.kind = ProofKind::kVariantSeparation, .said = *first, .bound = *second};
  }
  return {.kind = ProofKind::kVariantTouch,
          .bound = Outside(0, truth.separation),
          .touching = answer.touching};
}

/** States the overlaps along the two normals, which a reader can compute. */
Proof ProveOverlaps(const ContactQuery& query, const ContactAnswer& answer,
                    const ContactAnswer& back) {
  const auto overlap = [&](const Eigen::Vector3d& n_W) {
    const Enclosure along = OverlapAlong(query, n_W);
    return along.lo + (along.hi - along.lo) / 2;
  };
  const Eigen::Vector3d n_W = NormalOf(answer).value();
  const Eigen::Vector3d back_W = NormalOf(back).value();
  return {.kind = ProofKind::kVariantNormal,
          .said = overlap(n_W),
          .bound = overlap(back_W),
          .n_W = back_W,
          .claimed_W = n_W};
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
  double separation;  ///< [m]
  double overlap;     ///< [m]
  Tolerances base;    ///< Tolerances of the answer to the question.
  Tolerances other;   ///< Tolerances of the answer to the variant, on its own scene.
};

/** Returns the granted differences. Both separations may be off, and their errors add up.
 Both overlaps lie between the least overlap, which is the same for both, and the granted
 excess above it: they differ by no more than the larger excess. */
Granted GrantedBetween(const Scenario& scenario, const ContactTruth& truth,
                       const OracleInfo& oracle, const Variant& variant,
                       const Tolerances& base, bool variant_touching) {
  const double f = variant.factor;
  ContactTruth changed_truth;
  changed_truth.separation = {truth.separation.lo * f, truth.separation.hi * f};
  changed_truth.input_rounding = truth.input_rounding * f + variant.rounding;
  Granted granted;
  granted.base = base;
  granted.other = TolerancesOf(oracle, variant.query,
                               scenario.tolerance ? scenario.tolerance->separation : 0,
                               changed_truth, variant_touching);
  granted.separation = granted.base.separation + granted.other.separation / f;
  granted.overlap = std::max(granted.base.excess, granted.other.excess / f);
  return granted;
}

/** Words the grant of the separation, or that of the overlap. */
std::string Because(const Granted& granted, bool by_overlap,
                    const ToleranceReasons& because) {
  return by_overlap
             ? fmt::format(
                   "both normals may be longer than the shortest, the first by {:.2g} m "
                   "({}), the second by {:.2g} m on its own scene",
                   granted.base.excess, because.Excess(), granted.other.excess)
             : fmt::format(
                   "both answers may be off, the first by {:.2g} m ({}), the second by "
                   "{:.2g} m on its own scene",
                   granted.base.separation, because.Separation(),
                   granted.other.separation);
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
                                    const ContactAnswer& variant_answer,
                                    const Tolerances& tolerances, Reasons reasons) {
  const Granted granted = GrantedBetween(scenario, truth, oracle, variant, tolerances,
                                         variant_answer.touching);
  Finding finding;
  finding.scenario = scenario.id;
  finding.oracle = oracle.name;
  finding.measure = variant.measure;
  finding.tolerance = granted.separation;
  const ToleranceReasons because(oracle, scenario, truth, answer.touching, granted.base);
  const auto failed = [&](Verdict verdict, const std::string& why) {
    finding.verdict = verdict;
    if (finding.grade == Grade::kNone && IsUnusable(verdict))
      finding.grade = Grade::kUnusable;
    if (reasons == Reasons::kOfAll)
      finding.tolerance_because = Because(granted, false, because);
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
  if (const auto fault = InvalidityOf(variant_answer, granted.base.unit_normal)) {
    finding.grade = GradeOf(*fault);
    return failed(Verdict::kInvalid, fault->what);
  }
  const ContactQuery& query = scenario.contact;
  ContactAnswer back = BroughtBack(variant, variant_answer);
  const bool near = Outside(0, truth.separation) <= granted.separation + variant.play;
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
  const bool by_overlap = overlap * granted.separation > separation * granted.overlap;
  if (by_overlap) {
    finding.value = overlap;
    finding.tolerance = granted.overlap;
  }
  // Written so that a NaN fails.
  finding.verdict = finding.value <= finding.tolerance ? Verdict::kPass : Verdict::kFail;
  if (!std::isfinite(finding.tolerance)) finding.verdict = Verdict::kUndecidable;
  if (reasons == Reasons::kOfAll)
    finding.tolerance_because = Because(granted, by_overlap, because);
  const double fine = granted.base.fine;
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
    Proof proof = by_overlap ? ProveOverlaps(query, answer, back)
                             : ProveSeparations(truth, answer, back);
    proof.change = ChangeOf(query, variant);
    // The value of the finding excludes the change that the variant itself explains.
    proof.explained = variant.play;
    proof.rest = finding.value;
    State(std::move(proof), finding);
    if (variant.measure == MeasureKind::kSwap && NormalOf(back)) {
      const AnswerDifference left = AnswerChange(query, truth, answer, variant_answer);
      if (left.separation <= granted.separation && left.overlap <= granted.overlap) {
        finding.cause = Cause::kConvention;
        finding.cause_because = "its normal does not turn when A and B are swapped";
      }
    }
  }
  return finding;
}

}  // namespace touchstone
