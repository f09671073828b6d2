#include "reports/contacts/judge_answer.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "reports/contacts/body_size.h"
#include "reports/contacts/exact_scene.h"
#include "reports/contacts/grade.h"
#include "reports/contacts/missed_point.h"
#include "reports/contacts/normal_claim.h"
#include "reports/contacts/proof.h"
#include "reports/contacts/tolerance_reasons.h"
#include "reports/contacts/tolerances.h"
#include "reports/measures/consistency_error.h"
#include "reports/measures/contact_count.h"
#include "reports/measures/contact_off_patch.h"
#include "reports/measures/contact_separation_error.h"
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
#include "reports/measures/witness_error.h"
#include "reports/referee/referee.h"

namespace touchstone {
namespace {

/** The findings on one answer are about a dozen. Each is half a kilobyte, so that moving
 them to larger storage costs as much as some measures. */
constexpr std::size_t kMostFindings = 16;

/** The judgement of one answer. Each method adds the findings of one measure. */
class Judgement {
 public:
  Judgement(const Scenario& scenario, const ContactTruth& truth, const OracleInfo& oracle,
            const ContactAnswer& answer, Reasons reasons)
      : scenario_(scenario),
        query_(scenario.contact),
        truth_(truth),
        oracle_(oracle),
        answer_(answer),
        capability_(oracle.For(KindOf(query_.A.shape), KindOf(query_.B.shape))),
        tolerances_(TolerancesOf(oracle, scenario, truth, answer.touching)),
        because_(oracle, scenario, truth, answer.touching, tolerances_),
        reasons_(reasons),
        dispute_{query_, truth, answer},
        n_W_(NormalOf(answer)),
        separation_(SeparationOf(answer)) {}

  std::vector<Finding> Findings() && {
    if (!Answered()) return std::move(findings_);
    findings_.reserve(kMostFindings);
    if (const auto fault = InvalidityOf(answer_, tolerances_.unit_normal)) {
      Unanswered(Verdict::kInvalid, fault->what);
      findings_.back().grade = GradeOf(*fault);
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
    Add(MeasureKind::kAnswering, 0, 0, AnswerIsAnswer, [] { return ""; });
    return std::move(findings_);
  }

 private:
  /** Adds a finding. `because` is called for the reason of the tolerance if the finding
   carries it, and `prove` to make the proof of a failure. */
  template <typename Because, typename Prove>
  Finding& Add(MeasureKind measure, double value, double tolerance, Because because,
               Prove prove) {
    Finding& finding = findings_.emplace_back();
    finding.scenario = scenario_.id;
    finding.oracle = oracle_.name;
    finding.reference = "referee";
    finding.measure = measure;
    finding.value = value;
    finding.tolerance = tolerance;
    // Written so that a NaN fails.
    finding.verdict = value <= tolerance ? Verdict::kPass : Verdict::kFail;
    // If doubles overflow, the enclosure is unbounded and proves no answer wrong.
    if (!std::isfinite(tolerance)) finding.verdict = Verdict::kUndecidable;
    if (reasons_ == Reasons::kOfAll) finding.tolerance_because = because();
    if (UnitOf(measure) == "m") RequireFineTolerance(finding);
    if (finding.verdict == Verdict::kFail) {
      if (reasons_ != Reasons::kNone) {
        if constexpr (std::is_same_v<decltype(prove()), Proof>)
          State(prove(), finding);
        else
          finding.proof = prove();
      }
      finding.grade = GradeOf(finding, query_, truth_);
      finding.safety = tolerance > 0 ? kRoundingsSafety : 1;
    }
    return finding;
  }

  /** Replaces the reason of a finding that carries one by `reworded` of it. */
  template <typename Reworded>
  static void Reword(Finding& finding, Reworded reworded) {
    if (!finding.tolerance_because.empty())
      finding.tolerance_because = reworded(finding.tolerance_because);
  }

  /** Withdraws a pass within a tolerance that is too wide to tell right from wrong. A
   value that passes a fine tolerance as well remains a pass. */
  void RequireFineTolerance(Finding& finding) const {
    if (finding.verdict != Verdict::kPass || finding.tolerance <= tolerances_.fine)
      return;
    const bool is_fine = finding.value <= tolerances_.fine;
    Reword(finding, [&](const std::string& because) {
      return fmt::format(
          "{} {:.2g} m, a hundredth of the smallest feature and of the distance: {}",
          is_fine ? "narrowed to" : "wider than", tolerances_.fine, because);
    });
    if (is_fine) {
      finding.tolerance = tolerances_.fine;
    } else {
      finding.verdict = Verdict::kUndecidable;
      finding.undecided = Undecided::kCoarse;
    }
  }

  /** Withdraws a pass that is not proved because the truth is wider than the tolerance.
   @param most Called for the error if the truth is at the end of its enclosure that is
   worst for the answer. [m] */
  template <typename Most>
  void RequireProof(Finding& finding, Most most) const {
    const double width = truth_.separation.hi - truth_.separation.lo;
    if (finding.verdict != Verdict::kPass || !(width > finding.tolerance)) return;
    if (most() <= finding.tolerance) return;
    finding.verdict = Verdict::kUndecidable;
    Reword(finding, [&](const std::string& because) {
      return fmt::format(
          "the truth is known only to within {:.2g} m, more than is allowed: {}", width,
          because);
    });
  }

  /** Withdraws a failure that only a polygon in doubles tells. */
  static void Withdraw(Finding& finding, std::string_view why) {
    finding.verdict = Verdict::kUndecidable;
    finding.grade = Grade::kNone;
    finding.safety = 1;
    TakeBackProof(finding);
    Reword(finding, [&](const std::string& because) {
      return fmt::format("the patch is not certified here, and {}: {}", why, because);
    });
  }

  static std::string AnswerIsAnswer() { return "an answer is an answer"; }

  void Unanswered(Verdict verdict, const std::string& why) {
    Finding& finding = Add(MeasureKind::kAnswering, 1, 0, AnswerIsAnswer, [&] {
      return fmt::format("{}: {}{}", oracle_.name, why, why.ends_with('.') ? "" : ".");
    });
    finding.verdict = verdict;
    finding.grade = IsUnusable(verdict) ? Grade::kUnusable : Grade::kNone;
    finding.safety = 1;
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
      if (capability_.witnesses && !answer_.witnesses)
        return "apart, without the promised witness points";
      return std::nullopt;
    }
    if (capability_.depth && !separation_) return "touching, without the promised depth";
    // An engine that derives the normal from two witness points has none where they
    // coincide.
    const bool deep = truth_.separation.hi < -tolerances_.separation;
    if (capability_.normal && !n_W_ && deep) {
      return "touching, without the promised normal";
    }
    if (capability_.manifold && answer_.points.empty()) {
      return "touching, without a contact";
    }
    if (capability_.penetrating_witnesses && !answer_.witnesses) {
      return "touching, without the promised witness points";
    }
    return std::nullopt;
  }

  bool IsApart() const { return truth_.separation.lo > 0; }

  void JudgeTouching() {
    Finding& finding = Add(
        MeasureKind::kTouching, TouchingError(truth_, answer_), 0,
        [] { return "the truth is certified"; }, [&] { return ProveTouching(dispute_); });
    const std::optional<bool> sign = CertifiedTouching(truth_);
    const double from_touching = Outside(0, truth_.separation);
    const double e = tolerances_.separation;
    if (truth_.touching != Touching::kUndecided && finding.value == 0) return;
    if (truth_.touching != Touching::kUndecided && from_touching > e) return;
    if (IsExactScene(query_, oracle_.unit_roundoff)) {
      if (const auto exact = TouchingInExactScene(query_, truth_)) {
        DecideExactly(finding, *exact);
        return;
      }
    }
    finding.verdict = Verdict::kUndecidable;
    finding.undecided = !sign                       ? Undecided::kUnknown
                        : *sign == answer_.touching ? Undecided::kAgreed
                                                    : Undecided::kOpposed;
    Reword(finding, [&](const std::string&) {
      return truth_.touching == Touching::kUndecided
                 ? fmt::format("touching to within {:.2g} m, the rounding of the input{}",
                               truth_.input_rounding,
                               sign ? "" : ", or undecided by " + truth_.method)
                 : fmt::format("{:.2g} m from touching, within {:.2g} m: {}",
                               from_touching, e, because_.Separation());
    });
    finding.grade = Grade::kNone;
    finding.safety = 1;
    TakeBackProof(finding);
  }

  /** Judges `touching` in a scene whose numbers need no rounding. */
  void DecideExactly(Finding& finding, bool sign) const {
    finding.value = answer_.touching == sign ? 0 : 1;
    finding.verdict = finding.value > 0 ? Verdict::kFail : Verdict::kPass;
    finding.tolerance_because =
        "the truth is certified, and the numbers of the scene need no rounding";
    if (finding.verdict == Verdict::kPass) return;
    State(ProveTouching(dispute_), finding);
    finding.grade = GradeOf(finding, query_, truth_);
  }

  void JudgeSeparation() {
    if (!separation_) return;
    Finding& finding = Add(
        MeasureKind::kSeparationError, SeparationError(truth_, *separation_),
        tolerances_.separation, [&] { return because_.Separation(); },
        [&] { return ProveSeparation(dispute_, *separation_); });
    RequireProof(finding, [&] {
      return std::max(*separation_ - truth_.separation.lo,
                      truth_.separation.hi - *separation_);
    });
    if (!n_W_) return;  // No contacts either: they would have a normal.
    const double along = ConsistencyError(Along(), *separation_);
    const double unmet = ManifoldInconsistency(answer_.points, *separation_);
    Add(
        MeasureKind::kConsistencyError, std::max(along, unmet), tolerances_.apart,
        [&] { return because_.Apart(); },
        [&] {
          return along >= unmet
                     ? ProveInconsistency(dispute_, *n_W_, *separation_)
                     : ProveManifoldInconsistency(*separation_, *DeepestOf(answer_));
        });
  }

  bool IsNormalClaimed() const {
    return n_W_ && ClaimsLeastDirection(truth_, capability_, answer_);
  }

  void JudgeNormal() {
    if (!n_W_) return;
    if (!IsNormalClaimed()) {
      // A separation that is stated without a promise is judged along the normal.
      if (!separation_) JudgeSeparatingDirection();
      return;
    }
    Finding& finding = Add(
        MeasureKind::kExcess, Excess(Along(), truth_), tolerances_.excess,
        [&] { return because_.Excess(); }, [&] { return ProveExcess(dispute_, *n_W_); });
    RequireProof(finding, [&] { return Along().hi + truth_.separation.hi; });
    normal_is_right_ = finding.verdict == Verdict::kPass;
  }

  /** Judges the normal of bodies that are apart, from an oracle that promises no
   distance. Any direction that separates them is right, and its opposite wrong. Another
   direction claims nothing that could be verified. */
  void JudgeSeparatingDirection() {
    const bool opposite = OverlapAlong(query_, -*n_W_).hi < 0;
    Finding& finding = Add(
        MeasureKind::kExcess, std::max(0.0, Along().lo), tolerances_.apart,
        [&] { return because_.Apart(); },
        [&] { return ProveOppositeNormal(dispute_, *n_W_); });
    if (finding.verdict != Verdict::kFail || opposite) return;
    finding.verdict = Verdict::kUndecidable;
    finding.undecided = Undecided::kUnverified;
    finding.tolerance_because =
        "its normal separates nothing, and without a distance it claims nothing else";
    finding.grade = Grade::kNone;
    finding.safety = 1;
    TakeBackProof(finding);
  }

  void JudgeWitnesses() {
    if (!answer_.witnesses) return;
    const WitnessPoints& w = *answer_.witnesses;
    // Witness points that coincide are covered by the surface error below.
    if (IsApart() && !answer_.touching && w.p_WCa != w.p_WCb) {
      Add(
          MeasureKind::kDualityGap, DualityGap(query_, w), tolerances_.apart,
          [&] { return because_.Apart(); }, [&] { return ProveDualityGap(dispute_); });
    }
    if (separation_) JudgeWitnessError(w);
  }

  void JudgeWitnessError(const WitnessPoints& w) {
    const bool vector = IsNormalClaimed();
    const WitnessError error = vector
                                   ? WitnessErrorOf(w, *n_W_, *separation_)
                                   : WitnessError{WitnessLengthError(w, *separation_), 0};
    const double each = tolerances_.position;
    const double along = 3 * each;
    // Both points and the direction between them are rounded, however small the bodies.
    const double across = tolerances_.across + along;
    const bool by_across = error.across * along > error.along * across;
    const auto because = [&] {
      return fmt::format("two points and a separation, each off by {:.2g} m: {}{}", each,
                         because_.Position(), by_across ? "; " + because_.Across() : "");
    };
    Add(MeasureKind::kWitnessError, by_across ? error.across : error.along,
        by_across ? across : along, because, [&] {
          return ProveWitnessError(dispute_, vector ? &*n_W_ : nullptr, *separation_);
        });
  }

  /** The points of a contact on both bodies, or the witness points. */
  struct OnSurfaces {
    WitnessPoints points;
    Eigen::Vector3d n_W;  ///< Zero if there is none to judge.
    double gap;           ///< Separation of a contact; 0 for witness points. [m]
  };

  std::vector<OnSurfaces> AllOnSurfaces() const {
    std::vector<OnSurfaces> all;
    if (answer_.witnesses) {
      // Witness points of bodies that are apart are judged by their duality gap.
      const bool judged = n_W_ && answer_.touching;
      all.push_back({*answer_.witnesses,
                     judged ? *n_W_ : Eigen::Vector3d(Eigen::Vector3d::Zero()), 0});
    }
    for (const ContactPoint& contact : answer_.points) {
      const Eigen::Vector3d n = contact.n_AB_W.value_or(*n_W_).normalized();
      all.push_back({SurfacePointsOf(contact, n), n, contact.separation});
    }
    return all;
  }

  void JudgeContacts() {
    const std::vector<OnSurfaces> all = AllOnSurfaces();
    double surface = -1;
    const OnSurfaces* worst = nullptr;
    for (const OnSurfaces& on : all) {
      const double error = SurfaceError(query_, on.points);
      if (!(error <= surface)) {
        surface = error;
        worst = &on;
      }
    }
    if (worst == nullptr) return;
    const Finding& finding = Add(
        MeasureKind::kContactSurfaceError, surface, tolerances_.separation,
        [&] { return because_.Separation(); },
        [&] {
          return ProveSurfaceError(dispute_, worst->points.p_WCa, worst->points.p_WCb);
        });
    points_are_right_ = finding.verdict == Verdict::kPass;
    // Points off their surfaces, or along a wrong normal, are wrong already.
    if (points_are_right_ && normal_is_right_) JudgeSeparations(all);
  }

  /** Judges the own separation of every contact: neither may the bodies overlap there by
   more than it says, nor may it be apart. */
  void JudgeSeparations(const std::vector<OnSurfaces>& all) {
    const double e = tolerances_.position;
    const double least = tolerances_.across;
    double beyond = 0;
    double gap = 0;
    const OnSurfaces* worst = &all.front();
    for (const OnSurfaces& on : all) {
      if (on.n_W.isZero()) continue;
      const double more = ContactSeparationError(query_, on.points, on.n_W, e, least);
      if (more > beyond || (beyond == 0 && on.gap > gap)) worst = &on;
      beyond = std::max(beyond, more);
      gap = std::max(gap, on.gap);
    }
    if (beyond > 0 || gap <= e) {
      Add(
          MeasureKind::kContactSeparationError, beyond, tolerances_.across,
          [&] { return because_.Across(); },
          [&] { return ProveContactTooShallow(worst->points, beyond); });
    } else {
      Add(
          MeasureKind::kContactSeparationError, gap, tolerances_.separation,
          [&] { return because_.Separation(); },
          [&] { return ProveSurplusContact(worst->points, gap); });
    }
  }

  /** Judges the positions and the number of the contacts. Applies where the normal is
   right, since a patch belongs to a normal, and where the truth is narrow enough to
   identify the deepest contacts. */
  void JudgePatch() {
    const ContactPoint* deepest = DeepestOf(answer_);
    if (deepest == nullptr) return;
    const double e = tolerances_.separation;
    const bool certain = truth_.separation.hi - truth_.separation.lo <= e;
    if (normal_is_right_ && certain && answer_.touching) {
      JudgeOffPatch();
      // Where the whole patch overlaps by more than rounding, all of it must be covered.
      if (capability_.manifold && truth_.separation.hi < -2 * tolerances_.position)
        JudgeCoverage();
    }
    Finding& finding = Add(
        MeasureKind::kContactTooDeep, ContactTooDeep(truth_, *deepest),
        tolerances_.separation, [&] { return because_.Separation(); },
        [&] { return ProveTooDeep(dispute_, *deepest); });
    RequireProof(finding, [&] { return truth_.separation.hi - deepest->separation; });
  }

  /** Returns the overlap along the normal of the answer, evaluated once: several measures
   need it, and it is most of the cost of some. */
  const Enclosure& Along() {
    if (!along_) along_ = OverlapAlong(query_, *n_W_);
    return *along_;
  }

  /** Returns the separation along SupportingDirection(), midway through its enclosure. */
  double SupportedSeparation() {
    const Eigen::Vector3d n_W = SupportingDirection(query_, *n_W_);
    const Enclosure overlap = n_W == *n_W_ ? Along() : Overlap(query_, n_W);
    return -(overlap.lo + (overlap.hi - overlap.lo) / 2);
  }

  void JudgeOffPatch() {
    const double e = tolerances_.separation;
    // A contact as deep as the deepest to within e lies within √(2 e L) of the features
    // that are within √(2 e L) of the supporting plane, where L is the size of the scene.
    const Eigen::Vector3d n = SupportingDirection(query_, *n_W_);
    const ContactPatch patch =
        PatchAlong(query_, n, SupportedSeparation(), tolerances_.across / 2);
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
    const WidestRim rim = WidestUncertainRim();
    Finding& finding = Add(
        MeasureKind::kContactOffPatch, off, std::max(tolerances_.across, rim.width),
        [&] {
          return rim.lean < 0 ? because_.Across()
                              : fmt::format("{}, or along a rim that leans by {:.2g}",
                                            because_.Across(), rim.lean);
        },
        [&] { return ProveOffPatch(*worst, off); });
    // A contact at the greatest depth whose points lie on both surfaces is in the patch
    // by definition. The polygon is computed in doubles, and proves nothing against it.
    if (finding.verdict == Verdict::kFail && points_are_right_)
      Withdraw(finding, "its points are certified to lie on both surfaces");
  }

  /** A rim that may be the deepest feature, and how wide its deepest part is. */
  struct WidestRim {
    double width = 0;  ///< [m]
    double lean = -1;  ///< Sine of the angle to the normal; negative without a rim. [-]
  };

  /** Returns the rim whose deepest part is the widest. Along a rim of radius r that leans
   by θ the depth falls by only w² sin θ / 2r at the distance w. A depth off by e
   therefore leaves w = √(2 e r / sin θ) uncertain, at most the whole rim. */
  WidestRim WidestUncertainRim() const {
    WidestRim widest;
    for (const Body* body : {&query_.A, &query_.B}) {
      const ShapeKind kind = KindOf(body->shape);
      if (kind != ShapeKind::kCylinder && kind != ShapeKind::kCone) continue;
      const double lean = n_W_->cross(body->X_WB.R_WB.col(2)).norm();
      const double r = BoundingRadius(body->shape);
      const double e = tolerances_.position;
      const double open = lean * r > e ? std::sqrt(2 * e * r / lean) : 2 * r;
      const double most = std::min(2 * r, SmallerExtent(query_));
      const double width = std::min(2 * open, most);
      if (width >= widest.width) widest = {width, lean};
    }
    return widest;
  }

  void JudgeCoverage() {
    const double e = tolerances_.position;
    const Eigen::Vector3d n = SupportingDirection(query_, *n_W_);
    const ContactPatch patch =
        CertainPatch(query_, n, SupportedSeparation(), truth_.input_rounding, e);
    bool must_span = true;
    bool is_certain = true;
    if (patch.vertices_W.size() > 1) {
      const double unspanned = PatchUnspanned(patch, n, answer_.points);
      const double legal = LegalUnspanned(patch, n, answer_.points);
      const double blur = PatchBlur(patch, n, e);
      Finding& finding = Add(
          MeasureKind::kPatchCoverage, unspanned, legal + blur,
          [&] {
            return fmt::format(
                "{}, and sides off by {:.2g} m leave {:.2g} of it",
                legal > kLegalUnspanned
                    ? "a triangle inscribed in a disc leaves a quarter of its "
                      "diameter unspanned"
                    : "a sixteenth of its extent may be left unspanned",
                e, blur);
          },
          [] { return ""; });
      must_span = finding.verdict == Verdict::kFail;
      if (must_span) {
        const auto missed = CertainlyMissed(query_, patch, n, SupportedSeparation(),
                                            answer_.points, finding.tolerance, e);
        is_certain = missed.has_value();
        if (missed) {
          State(ProveUnspanned(dispute_, *missed, unspanned), finding);
        } else {
          Withdraw(finding, "no point that is certified to belong to it is missed");
        }
      }
    }
    const int least = must_span ? patch.least_contacts : 0;
    Finding& count = Add(
        MeasureKind::kContactCount, ContactCountError(least, answer_.points, e), 0,
        [] { return "the patch needs that many"; },
        [&] { return ProveCount(dispute_, patch); });
    // Contacts that are repeated are too many of any patch.
    if (count.verdict == Verdict::kFail && !is_certain &&
        ContactCountError(0, answer_.points, e) == 0)
      Withdraw(count, "no point that is certified to belong to it is missed");
  }

  void JudgeMixedNormals() {
    const bool has_two =
        answer_.points.size() > 1 || (answer_.points.size() == 1 && answer_.n_AB_W);
    if (!has_two) return;
    const double angle = MixedNormals(answer_);
    Add(
        MeasureKind::kMixedNormals, angle, tolerances_.angle,
        [&] { return because_.Angle(); }, [&] { return ProveMixedNormals(angle); });
  }

  const Scenario& scenario_;
  const ContactQuery& query_;
  const ContactTruth& truth_;
  const OracleInfo& oracle_;
  const ContactAnswer& answer_;
  const Capability& capability_;
  const Tolerances tolerances_;
  const ToleranceReasons because_;
  const Reasons reasons_;
  const Dispute dispute_;
  const std::optional<Eigen::Vector3d> n_W_;
  const std::optional<double> separation_;
  bool normal_is_right_ = false;
  bool points_are_right_ = false;
  std::optional<Enclosure> along_;  ///< Along(), once it is known.
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> JudgeAnswer(const Scenario& scenario, const ContactTruth& truth,
                                 const OracleInfo& oracle, const ContactAnswer& answer,
                                 Reasons reasons) {
  return Judgement(scenario, truth, oracle, answer, reasons).Findings();
}

}  // namespace touchstone
