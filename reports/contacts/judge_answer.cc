#include "reports/contacts/judge_answer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "reports/contacts/proof.h"
#include "reports/contacts/tolerances.h"
#include "reports/measures/consistency_error.h"
#include "reports/measures/contact_count.h"
#include "reports/measures/contact_off_patch.h"
#include "reports/measures/contact_surface_error.h"
#include "reports/measures/contact_too_deep.h"
#include "reports/measures/duality_gap.h"
#include "reports/measures/excess.h"
#include "reports/measures/invalidity.h"
#include "reports/measures/mixed_normals.h"
#include "reports/measures/outside.h"
#include "reports/measures/overlap_along.h"
#include "reports/measures/patch_coverage.h"
#include "reports/measures/separation_error.h"
#include "reports/measures/stated.h"
#include "reports/measures/touching.h"
#include "reports/referee/referee.h"

namespace touchstone {
namespace {

/** The judgement of one answer. Each method adds the findings of one measure. */
class Judgement {
 public:
  Judgement(const Scenario& scenario, const ContactTruth& truth, const OracleInfo& oracle,
            const ContactAnswer& answer)
      : scenario_(scenario),
        query_(scenario.contact),
        truth_(truth),
        oracle_(oracle),
        answer_(answer),
        capability_(oracle.For(KindOf(query_.A.shape), KindOf(query_.B.shape))),
        tolerances_(TolerancesOf(oracle, scenario, truth)),
        dispute_{oracle.name, query_, truth, answer},
        n_W_(NormalOf(answer)),
        separation_(SeparationOf(answer)) {}

  std::vector<Finding> Findings() && {
    if (!Answered()) return std::move(findings_);
    if (const auto fault = InvalidityOf(answer_, tolerances_.unit_normal)) {
      Unanswered(Verdict::kInvalid, *fault);
      return std::move(findings_);
    }
    JudgeTouching();
    if (const auto missing = MissingField()) {
      Unanswered(Verdict::kInvalid, *missing);
      return std::move(findings_);
    }
    JudgeSeparation();
    JudgeNormal();
    JudgeWitnesses();
    JudgeContacts();
    JudgePatch();
    JudgeMixedNormals();
    Add(MeasureKind::kAnswering, 0, {0, "an answer is an answer"}, [] { return ""; });
    return std::move(findings_);
  }

 private:
  /** Adds a finding. `prove` is called to make the proof of a failure. */
  template <typename Prove>
  Finding& Add(MeasureKind measure, double value, const Tolerance& tolerance,
               Prove prove) {
    Finding& finding = findings_.emplace_back();
    finding.scenario = scenario_.id;
    finding.oracle = oracle_.name;
    finding.reference = "referee";
    finding.measure = measure;
    finding.value = value;
    finding.tolerance = tolerance.value;
    finding.tolerance_because = tolerance.because;
    // Written so that a NaN fails.
    finding.verdict = value <= tolerance.value ? Verdict::kPass : Verdict::kFail;
    // If doubles overflow, the enclosure is unbounded and proves no answer wrong.
    if (!std::isfinite(tolerance.value)) finding.verdict = Verdict::kUndecidable;
    if (finding.verdict == Verdict::kFail) finding.proof = prove();
    return finding;
  }

  /** Withdraws a pass that is not proved because the truth is wider than the tolerance.
   @param most The error if the truth is at the end of its enclosure that is worst for the
   answer. [m] */
  void RequireProof(Finding& finding, double most) const {
    const double width = truth_.separation.hi - truth_.separation.lo;
    if (finding.verdict != Verdict::kPass || !(width > finding.tolerance)) return;
    if (most <= finding.tolerance) return;
    finding.verdict = Verdict::kUndecidable;
    finding.tolerance_because = fmt::format(
        "the truth is known only to within {:.2g} m, more than is allowed: {}", width,
        finding.tolerance_because);
  }

  void Unanswered(Verdict verdict, const std::string& why) {
    Finding& finding =
        Add(MeasureKind::kAnswering, 1, {0, "an answer is an answer"}, [&] {
          return fmt::format("{}: {}{}", oracle_.name, why,
                             why.ends_with('.') ? "" : ".");
        });
    finding.verdict = verdict;
  }

  bool Answered() {
    switch (answer_.status) {
      case AnswerStatus::kAnswered:
        return true;
      case AnswerStatus::kUnsupported:
        Unanswered(Verdict::kUnsupported, answer_.reason);
        findings_.back().value = 0;
        return false;
      case AnswerStatus::kCrashed:
        Unanswered(Verdict::kCrashed, answer_.reason);
        return false;
      case AnswerStatus::kTimedOut:
        Unanswered(Verdict::kTimedOut, answer_.reason);
        return false;
    }
    return false;
  }

  /** Returns the field that the oracle promises for this pair but did not return. */
  std::optional<std::string> MissingField() const {
    if (!answer_.touching) {
      if (capability_.distance && !separation_)
        return "apart, without the promised distance";
      return std::nullopt;
    }
    if (capability_.depth && !separation_) return "touching, without the promised depth";
    // An engine that derives the normal from two witness points has none where they
    // coincide.
    const bool deep = truth_.separation.hi < -tolerances_.separation.value;
    if (capability_.normal && !n_W_ && deep) {
      return "touching, without the promised normal";
    }
    if (capability_.manifold && answer_.points.empty()) {
      return "touching, without a contact";
    }
    return std::nullopt;
  }

  bool IsApart() const { return truth_.separation.lo > 0; }

  void JudgeTouching() {
    Finding& finding =
        Add(MeasureKind::kTouching, TouchingError(truth_, answer_),
            {0, "the truth is certified"}, [&] { return ProveTouching(dispute_); });
    const double from_touching = Outside(0, truth_.separation);
    if (truth_.touching == Touching::kUndecided) {
      finding.verdict = Verdict::kUndecidable;
      finding.tolerance_because = fmt::format(
          "touching to within {:.2g} m, the rounding of the input, or undecided by {}",
          truth_.input_rounding, truth_.method);
    } else if (finding.value > 0 && from_touching <= tolerances_.separation.value) {
      finding.verdict = Verdict::kUndecidable;
      finding.tolerance_because =
          fmt::format("{:.2g} m from touching, within {:.2g} m: {}", from_touching,
                      tolerances_.separation.value, tolerances_.separation.because);
      finding.proof.clear();
    }
  }

  void JudgeSeparation() {
    if (!separation_) return;
    Finding& finding = Add(MeasureKind::kSeparationError,
                           SeparationError(truth_, *separation_), tolerances_.separation,
                           [&] { return ProveSeparation(dispute_, *separation_); });
    RequireProof(finding, std::max(*separation_ - truth_.separation.lo,
                                   truth_.separation.hi - *separation_));
    if (!n_W_) return;  // No contacts either: they would have a normal.
    const double along = ConsistencyError(query_, *n_W_, *separation_);
    const double unmet = ManifoldInconsistency(answer_.points, *separation_);
    Add(MeasureKind::kConsistencyError, std::max(along, unmet), tolerances_.apart, [&] {
      return along >= unmet ? ProveInconsistency(dispute_, *n_W_, *separation_)
                            : ProveManifoldInconsistency(dispute_, *separation_,
                                                         *DeepestOf(answer_));
    });
  }

  /** Judges the normal. Where the bodies are apart, any separating direction is a legal
   normal, unless the oracle promises distances: then it claims the direction of the
   distance. */
  void JudgeNormal() {
    if (!n_W_ || (IsApart() && !answer_.touching && !capability_.distance)) return;
    Finding& finding =
        Add(MeasureKind::kExcess, Excess(query_, truth_, *n_W_), tolerances_.excess,
            [&] { return ProveExcess(dispute_, *n_W_); });
    RequireProof(finding, OverlapAlong(query_, *n_W_).hi + truth_.separation.hi);
    normal_is_right_ = finding.verdict == Verdict::kPass;
  }

  void JudgeWitnesses() {
    if (!answer_.witnesses || !IsApart() || answer_.touching) return;
    const WitnessPoints& w = *answer_.witnesses;
    if (w.p_WCa == w.p_WCb) return;  // Covered by the surface error below.
    Add(MeasureKind::kDualityGap, DualityGap(query_, w), tolerances_.apart,
        [&] { return ProveDualityGap(dispute_); });
  }

  void JudgeContacts() {
    double surface = -1;
    WitnessPoints worst;
    const auto consider = [&](double error, const WitnessPoints& points) {
      if (!(error <= surface)) {
        surface = error;
        worst = points;
      }
    };
    if (answer_.witnesses) {
      consider(WitnessSurfaceError(query_, *answer_.witnesses), *answer_.witnesses);
    }
    for (const ContactPoint& contact : answer_.points) {
      const Eigen::Vector3d n = contact.n_AB_W.value_or(*n_W_).normalized();
      consider(ContactSurfaceError(query_, *n_W_, contact),
               {contact.p_WC - n * (contact.separation / 2),
                contact.p_WC + n * (contact.separation / 2)});
    }
    if (surface < 0) return;
    Add(MeasureKind::kContactSurfaceError, surface, tolerances_.separation,
        [&] { return ProveSurfaceError(dispute_, worst.p_WCa, worst.p_WCb); });
  }

  /** Judges the positions and the number of the contacts. Applies where the normal is
   right, since a patch belongs to a normal, and where the truth is narrow enough to
   identify the deepest contacts. */
  void JudgePatch() {
    const ContactPoint* deepest = DeepestOf(answer_);
    if (deepest == nullptr) return;
    const double e = tolerances_.separation.value;
    const bool certain = truth_.separation.hi - truth_.separation.lo <= e;
    if (normal_is_right_ && certain && answer_.touching) {
      JudgeOffPatch();
      // Where the whole patch overlaps by more than rounding, all of it must be covered.
      if (capability_.manifold && truth_.separation.hi < -2 * e) JudgeCoverage();
    }
    Finding& finding =
        Add(MeasureKind::kContactTooDeep, ContactTooDeep(truth_, *deepest),
            tolerances_.separation, [&] { return ProveTooDeep(dispute_, *deepest); });
    RequireProof(finding, truth_.separation.hi - deepest->separation);
  }

  /** Returns the separation along the normal of the answer, midway through its enclosure.
   */
  double SeparationAlong(const Eigen::Vector3d& n_W) const {
    const Enclosure overlap = Overlap(query_, n_W);
    return -(overlap.lo + (overlap.hi - overlap.lo) / 2);
  }

  void JudgeOffPatch() {
    const double e = tolerances_.separation.value;
    // A contact as deep as the deepest to within e lies within √(2 e L) of the features
    // that are within √(2 e L) of the supporting plane, where L is the size of the scene.
    const Eigen::Vector3d n = SupportingDirection(query_, *n_W_);
    const ContactPatch patch =
        PatchAlong(query_, n, SeparationAlong(n), tolerances_.across.value / 2);
    if (patch.vertices_W.empty()) return;
    double off = -1;
    const ContactPoint* worst = nullptr;
    for (const ContactPoint& contact : answer_.points) {
      if (contact.separation > truth_.separation.hi + e) continue;
      const double distance = ContactOffPatch(patch, *n_W_, contact);
      if (!(distance <= off)) {
        off = distance;
        worst = &contact;
      }
    }
    if (worst == nullptr) return;
    Add(MeasureKind::kContactOffPatch, off, AcrossWithRims(),
        [&] { return ProveOffPatch(dispute_, *worst, off); });
  }

  /** Returns the tolerance across the normal where a rim may be the deepest feature.
   Along a rim of radius r that leans by θ the depth falls by only w² sin θ / 2r at the
   distance w. A depth off by e therefore leaves w = √(2 e r / sin θ) uncertain, at most
   the whole rim. */
  Tolerance AcrossWithRims() const {
    Tolerance tolerance = tolerances_.across;
    for (const Body* body : {&query_.A, &query_.B}) {
      const ShapeKind kind = KindOf(body->shape);
      if (kind != ShapeKind::kCylinder && kind != ShapeKind::kCone) continue;
      const double lean = n_W_->cross(body->X_WB.R_WB.col(2)).norm();
      const double r = BoundingRadius(body->shape);
      const double e = tolerances_.separation.value;
      const double open = lean * r > e ? std::sqrt(2 * e * r / lean) : 2 * r;
      tolerance.value = std::max(tolerance.value, 2 * std::min(open, 2 * r));
      tolerance.because = fmt::format("{}, or along a rim that leans by {:.2g}",
                                      tolerances_.across.because, lean);
    }
    return tolerance;
  }

  void JudgeCoverage() {
    const double e = tolerances_.separation.value;
    const Eigen::Vector3d n = SupportingDirection(query_, *n_W_);
    const ContactPatch patch =
        CertainPatch(query_, n, SeparationAlong(n), truth_.input_rounding, e);
    if (patch.vertices_W.size() > 1) {
      const double unspanned = PatchUnspanned(patch, n, answer_.points);
      const double blur = PatchBlur(patch, n, e);
      Add(MeasureKind::kPatchCoverage, unspanned,
          {LegalUnspanned(patch) + blur,
           fmt::format("a triangle inscribed in a disc leaves a quarter of its diameter "
                       "unspanned, and sides off by {:.2g} m leave {:.2g} of it",
                       e, blur)},
          [&] { return ProveUnspanned(dispute_, patch, unspanned); });
    }
    Add(MeasureKind::kContactCount, ContactCountError(patch, answer_.points, e),
        {0, "the patch needs that many"}, [&] { return ProveCount(dispute_, patch); });
  }

  void JudgeMixedNormals() {
    if (answer_.points.size() < 2) return;
    const double angle = MixedNormals(answer_);
    Add(MeasureKind::kMixedNormals, angle, tolerances_.angle,
        [&] { return ProveMixedNormals(dispute_, angle); });
  }

  const Scenario& scenario_;
  const ContactQuery& query_;
  const ContactTruth& truth_;
  const OracleInfo& oracle_;
  const ContactAnswer& answer_;
  const Capability& capability_;
  const Tolerances tolerances_;
  const Dispute dispute_;
  const std::optional<Eigen::Vector3d> n_W_;
  const std::optional<double> separation_;
  bool normal_is_right_ = false;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> JudgeAnswer(const Scenario& scenario, const ContactTruth& truth,
                                 const OracleInfo& oracle, const ContactAnswer& answer) {
  return Judgement(scenario, truth, oracle, answer).Findings();
}

}  // namespace touchstone
