#include "reports/sweep/count_answer.h"

#include <cmath>
#include <limits>

#include "reports/finding/ending.h"

namespace touchstone {
namespace {

FindingKind KindOf(const Finding& finding, const JudgedAnswer& answer) {
  return {.measure = finding.measure,
          .verdict = finding.verdict,
          .grade = finding.grade,
          .cause = finding.cause,
          .law = finding.law,
          .ending = EndingOf(finding),
          .touching = answer.touching || answer.undecided};
}

/** Returns the share of a finding such that it can be ordered. */
double OrderedShareOf(const Finding& finding, const JudgedAnswer& answer) {
  const double share = answer.share_of(finding);
  return std::isnan(share) ? std::numeric_limits<double>::infinity() : share;
}

void AddFinding(const Finding& finding, const JudgedAnswer& answer, OracleTally& tally) {
  ++tally.findings[KindOf(finding, answer)];
  // A measure that proves nothing is neither among the values nor among the worst.
  if (finding.verdict == Verdict::kUndecidable ||
      finding.verdict == Verdict::kUnsupported) {
    return;
  }
  const Measurand measurand{finding.measure, finding.law};
  tally.sketches[measurand].Add(finding.value);
  Insert({.question = answer.question,
          .value = finding.value,
          .tolerance = finding.tolerance,
          .tolerances = RelativeToTolerance(finding),
          .share = OrderedShareOf(finding, answer),
          .verdict = finding.verdict,
          .grade = finding.grade},
         tally.worst[measurand]);
}

}  // namespace

void CountAnswer(const JudgedAnswer& answer, OracleTally& tally) {
  const Outcome& outcome = answer.outcome;
  ++tally.asked;
  if (answer.touching) ++tally.touching;
  if (answer.undecided) ++tally.undecided;
  for (const Finding& finding : outcome.findings) AddFinding(finding, answer, tally);
  if (IsVerified(outcome.findings)) {
    ++tally.verified;
    if (answer.touching) ++tally.verified_touching;
  }
  if (outcome.decisive == nullptr) return;
  const Finding& decisive = *outcome.decisive;
  FindingKind kind = KindOf(decisive, answer);
  kind.verdict = outcome.verdict;
  ++tally.answers[kind];
  if (!IsFailure(outcome.verdict)) return;
  const double share = OrderedShareOf(decisive, answer);
  std::vector<FailedQuestion>& of_kind = tally.failures[kind];
  if (!IsKept(answer.question, share, of_kind)) return;
  Insert(FailedQuestion{.question = answer.question,
                        .kind = kind,
                        .value = decisive.value,
                        .tolerance = decisive.tolerance,
                        .share = share,
                        .proof = decisive.proof,
                        .scenario = answer.write()},
         of_kind);
}

}  // namespace touchstone
