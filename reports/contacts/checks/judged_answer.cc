#include "reports/contacts/checks/judged_answer.h"

#include <cmath>

#include <fmt/format.h>

#include "reports/contacts/checks/refutation.h"
#include "reports/contacts/grade.h"
#include "reports/contacts/normal_claim.h"
#include "reports/measures/overlap_along.h"
#include "reports/measures/stated.h"
#include "reports/referee/referee.h"

namespace touchstone {
namespace {

/** The findings on one answer are about a dozen. Each is half a kilobyte, so that moving
 them to larger storage costs as much as some measures. */
constexpr std::size_t kMostFindings = 16;

}  // namespace

JudgedAnswer::JudgedAnswer(const Scenario& scenario, const ContactTruth& contact_truth,
                           const OracleInfo& oracle_info,
                           const ContactAnswer& contact_answer, Reasons reasons)
    : query(scenario.contact),
      truth(contact_truth),
      oracle(oracle_info),
      answer(contact_answer),
      capability(oracle.For(KindOf(query.A.shape), KindOf(query.B.shape))),
      tolerances(TolerancesOf(oracle, scenario, truth, answer.touching)),
      because(oracle, scenario, truth, answer.touching, tolerances),
      n_W(NormalOf(answer)),
      separation(SeparationOf(answer)),
      scenario_(scenario.id),
      reasons_(reasons) {
  if (answer.status == AnswerStatus::kAnswered) findings_.reserve(kMostFindings);
}

bool JudgedAnswer::ClaimsLeastDirection() const {
  return n_W && touchstone::ClaimsLeastDirection(truth, capability, answer);
}

const Enclosure& JudgedAnswer::Along() {
  if (!along_) along_ = OverlapAlong(query, *n_W);
  return *along_;
}

double JudgedAnswer::SupportedSeparation() {
  const Eigen::Vector3d supporting_W = SupportingDirection(query, *n_W);
  const Enclosure overlap = supporting_W == *n_W ? Along() : Overlap(query, supporting_W);
  return -MiddleOf(overlap);
}

JudgedAnswer::Ruling JudgedAnswer::RulingOn(const Measured& measured) const {
  double tolerance = measured.tolerance;
  // If doubles overflow, the enclosure is unbounded and proves no answer wrong.
  if (!std::isfinite(tolerance)) return {Verdict::kUndecidable, tolerance};
  const bool worded = reasons_ == Reasons::kOfAll;
  // Written so that a NaN fails.
  if (!(measured.value <= tolerance)) {
    if (measured.unproved.empty()) return {Verdict::kFail, tolerance};
    Ruling ruling{Verdict::kUndecidable, tolerance};
    if (worded)
      ruling.qualification =
          fmt::format("the patch is not certified here, and {}: ", measured.unproved);
    return ruling;
  }
  Ruling ruling{Verdict::kPass, tolerance};
  if (UnitOf(measured.measure) == "m" && !(tolerance <= tolerances.fine)) {
    // A tolerance that is too wide tells right from wrong only for values that pass a
    // fine one as well.
    const bool is_fine = measured.value <= tolerances.fine;
    if (worded)
      ruling.qualification = fmt::format(
          "{} {:.2g} m, a hundredth of the smallest feature and of the distance: ",
          is_fine ? "narrowed to" : "wider than", tolerances.fine);
    if (!is_fine) {
      ruling.verdict = Verdict::kUndecidable;
      ruling.undecided = Undecided::kCoarse;
      return ruling;
    }
    tolerance = ruling.tolerance = tolerances.fine;
  }
  const double width = truth.separation.hi - truth.separation.lo;
  if (measured.worst && width > tolerance && !(*measured.worst <= tolerance)) {
    ruling.verdict = Verdict::kUndecidable;
    if (worded)
      ruling.qualification = fmt::format(
          "the truth is known only to within {:.2g} m, more than is allowed: {}", width,
          ruling.qualification);
  }
  return ruling;
}

Finding& JudgedAnswer::Add(MeasureKind measure, double value, double tolerance) {
  Finding& finding = findings_.emplace_back();
  finding.scenario = scenario_;
  finding.oracle = oracle.name;
  finding.reference = "referee";
  finding.measure = measure;
  finding.value = value;
  finding.tolerance = tolerance;
  return finding;
}

void JudgedAnswer::SetGrade(Finding& finding) const {
  finding.grade = GradeOf(finding, query, truth);
  finding.safety = finding.tolerance > 0 ? kRoundingsSafety : 1;
}

Finding& JudgedAnswer::AddAnswering(Verdict verdict, std::string_view why) {
  const bool is_missing = IsUnusable(verdict);
  Finding& finding = Add(MeasureKind::kAnswering, is_missing ? 1 : 0, 0);
  finding.verdict = verdict;
  if (reasons_ == Reasons::kOfAll) finding.tolerance_because = "an answer is an answer";
  if (is_missing) finding.grade = Grade::kUnusable;
  if (verdict != Verdict::kPass && reasons_ != Reasons::kNone)
    finding.proof =
        fmt::format("{}: {}{}", oracle.name, why, why.ends_with('.') ? "" : ".");
  return finding;
}

}  // namespace touchstone
