#include "reports/variants.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "reports/measures/answer_change.h"
#include "reports/measures/invalidity.h"
#include "reports/measures/outside.h"
#include "reports/measures/stated.h"
#include "reports/proof.h"
#include "reports/tolerance.h"
#include "scenarios/cube_rotations.h"
#include "scenarios/transformations.h"

namespace touchstone {
namespace {

/** Small, so that absolute tolerances of an engine show, and not a power of two, so that
 digits do change. [-] */
constexpr double kScale = 1 / 7.3;

/** Of the scene: sixteen times the rounding of a float, so that float engines see it, and
 far below any feature. [-] */
constexpr double kPerturbation = 0x1p-20;

/** A direction along nothing. */
const Eigen::Vector3d& AwkwardDirection() {
  static const Eigen::Vector3d direction =
      Eigen::Vector3d(0.52831, -0.77123, 0.35507).normalized();
  return direction;
}

/** FNV-1a, so that the choice is the same on every machine. */
std::uint32_t HashOf(const std::string& id) {
  std::uint32_t hash = 2166136261U;
  for (const char c : id) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return hash;
}

/** A motion by some metres, about no axis. */
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

/** "touching, -0.0134 m along (0, 0.6, 0.8)", as far as the answer says. */
std::string Said(const ContactAnswer& answer) {
  std::string words = answer.touching ? "touching" : "apart";
  if (const auto separation = SeparationOf(answer)) {
    words += fmt::format(", {:.9g} m", *separation);
  }
  if (const auto n_W = NormalOf(answer)) words += " along " + InWords(*n_W);
  return words;
}

/** What `answer` states and `back` does not, "" where nothing is missing.
 @param promised Whether the oracle gives distances of pairs apart. */
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

/** What an answer and that to a variant, brought back, may differ by. */
struct Granted {
  Tolerance separation;
  Tolerance overlap;
};

/** Both separations may be off, which adds up. Both overlaps lie between the least, which
 is one for both, and what is granted above it: they differ by no more than the larger. */
Granted GrantedBetween(const Scenario& scenario, const ContactTruth& truth,
                       const OracleInfo& oracle, const Variant& variant) {
  const double f = variant.factor;
  Scenario changed = scenario;
  changed.contact = variant.query;
  ContactTruth changed_truth = truth;
  changed_truth.separation = {truth.separation.lo * f, truth.separation.hi * f};
  changed_truth.input_rounding = truth.input_rounding * f + variant.rounding;
  const Tolerances base = TolerancesOf(oracle, scenario, truth);
  const Tolerances other = TolerancesOf(oracle, changed, changed_truth);
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
    // 0 is the identity.
    const int symmetry = 1 + static_cast<int>(HashOf(scenario.id) % (kCubeRotations - 1));
    add(MeasureKind::kRelabelling, Relabelled(query, symmetry, kCubeRotations - symmetry),
        1, 0);
  }
  const double shift = kPerturbation * SceneSize(query);
  // The depth moves by at most the shift, and so does the overlap along a fixed
  // direction; the overlap along the direction that is best for the moved B, by both.
  add(MeasureKind::kPerturbation, Perturbed(query, shift * AwkwardDirection()), 1,
      2 * shift);
  return variants;
}

std::optional<Finding> JudgeVariant(const Scenario& scenario, const ContactTruth& truth,
                                    const OracleInfo& oracle, const ContactAnswer& answer,
                                    const Variant& variant,
                                    const ContactAnswer& variant_answer) {
  const Granted granted = GrantedBetween(scenario, truth, oracle, variant);
  Finding finding;
  finding.scenario = scenario.id;
  finding.oracle = oracle.name;
  finding.measure = variant.measure;
  finding.tolerance = granted.separation.value;
  finding.tolerance_because = granted.separation.because;
  const auto failed = [&](Verdict verdict, const std::string& why) {
    finding.verdict = verdict;
    finding.proof = fmt::format("{} answers the question, but not its variant ({}): {}.",
                                oracle.name, NameOf(variant.measure), why);
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
  const double unit_slack = TolerancesOf(oracle, scenario, truth).unit_normal;
  if (const auto fault = InvalidityOf(variant_answer, unit_slack)) {
    return failed(Verdict::kInvalid, *fault);
  }
  const ContactQuery& query = scenario.contact;
  ContactAnswer back = BroughtBack(variant, variant_answer);
  const bool near =
      Outside(0, truth.separation) <= granted.separation.value + variant.play;
  // Apart, only an oracle that gives distances says which of all separating directions it
  // gives.
  const Capability& capability = oracle.For(KindOf(query.A.shape), KindOf(query.B.shape));
  // Who takes the normal from a pair of witness points has none where these coincide.
  const std::string_view missing =
      near ? "" : MissingOf(answer, back, capability.distance);
  if (!missing.empty()) {
    return failed(Verdict::kInvalid, fmt::format("it gives no {}", missing));
  }
  if (truth.separation.lo > 0 && !answer.touching && !capability.distance) {
    ForgetNormals(back);
  }
  const AnswerDifference change = AnswerChange(query, truth, answer, back);
  if (near && !change.compared) return std::nullopt;
  const double separation = std::max(0.0, change.separation - variant.play);
  const double overlap = std::max(0.0, change.overlap - variant.play);
  // Of the two, what is further beyond its tolerance.
  finding.value = separation;
  if (overlap * granted.separation.value > separation * granted.overlap.value) {
    finding.value = overlap;
    finding.tolerance = granted.overlap.value;
    finding.tolerance_because = granted.overlap.because;
  }
  // Written so that a NaN fails.
  finding.verdict = finding.value <= finding.tolerance ? Verdict::kPass : Verdict::kFail;
  if (!std::isfinite(finding.tolerance)) finding.verdict = Verdict::kUndecidable;
  if (finding.verdict == Verdict::kFail) {
    finding.proof = fmt::format(
        "{} says {}; of its variant ({}), brought back, it says {}: a difference of "
        "{:.9g} m.",
        oracle.name, Said(answer), NameOf(variant.measure), Said(back),
        finding.value + variant.play);
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
