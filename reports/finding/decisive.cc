#include "reports/finding/decisive.h"

#include "reports/finding/tolerance.h"

namespace touchstone {
namespace {

/** Returns the rank of a verdict among those of one answer; the largest decides. */
int RankOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::kUnsupported:
      return 0;
    case Verdict::kPass:
      return 1;
    case Verdict::kUndecidable:
      return 2;
    case Verdict::kKnown:
      return 3;
    case Verdict::kDisagree:
      return 4;
    case Verdict::kFail:
      return 5;
    case Verdict::kInvalid:
      return 6;
    case Verdict::kTimedOut:
      return 8;
    case Verdict::kCrashed:
      return 9;
  }
  return 9;
}

/** Returns the rank of a finding. A wrong hit or miss outweighs a field that is missing
 because of it. An answer that is invalid only by the length of a normal is one that is
 wrong by so much. */
int RankOf(const Finding& finding) {
  constexpr int kWrongTouch = 7;
  const bool is_off_unit =
      finding.verdict == Verdict::kInvalid && finding.grade != Grade::kUnusable;
  if (is_off_unit) return RankOf(Verdict::kFail);
  const bool is_wrong_touch =
      finding.verdict == Verdict::kFail && finding.grade == Grade::kWrongTouch;
  return is_wrong_touch ? kWrongTouch : RankOf(finding.verdict);
}

/** Returns whether `finding` shows a graver fault than `than`, or a reason that leaves
 more open, or else is a simpler or stronger proof of the same. A wrong length is graver
 than a wrong number of contacts, whatever their grades. Measures are enumerated from
 simple to complex: a separating plane, a number that the truth contradicts, then
 metamorphic variants. For the same measure, the finding farther beyond its tolerance is
 better. */
bool IsBetterProof(const Finding& finding, const Finding& than) {
  if (CountsContacts(finding.measure) != CountsContacts(than.measure))
    return CountsContacts(than.measure);
  if (finding.grade != than.grade) return finding.grade > than.grade;
  if (finding.verdict == Verdict::kUndecidable && finding.undecided != than.undecided)
    return finding.undecided > than.undecided;
  if (finding.measure != than.measure) return finding.measure < than.measure;
  return RelativeToTolerance(finding) > RelativeToTolerance(than);
}

}  // namespace

double RelativeToTolerance(const Finding& finding) {
  return InTolerances(finding.value, finding.tolerance);
}

const Finding* DecisiveOf(std::span<const Finding> of_one_answer) {
  const Finding* decisive = nullptr;
  for (const Finding& finding : of_one_answer) {
    if (decisive == nullptr || RankOf(finding) > RankOf(*decisive) ||
        (RankOf(finding) == RankOf(*decisive) && IsBetterProof(finding, *decisive)))
      decisive = &finding;
  }
  return decisive;
}

}  // namespace touchstone
