#include "reports/contacts/grade.h"

#include <algorithm>

#include "reports/contacts/body_size.h"
#include "reports/finding/grade.h"
#include "reports/measures/outside.h"

namespace touchstone {

double ShareOf(const Finding& finding, const ContactQuery& query,
               const ContactTruth& truth) {
  if (finding.measure == MeasureKind::kTouching) {
    return finding.value > 0 ? Outside(0, truth.separation) / SmallerExtent(query) : 0;
  }
  return UnitOf(finding.measure) == "m" ? finding.value / SmallerExtent(query)
                                        : finding.value;
}

Grade GradeOf(const Finding& finding, const ContactQuery& query,
              const ContactTruth& truth) {
  const Grade grade = GradeOfShare(ShareOf(finding, query, truth));
  if (CountsContacts(finding.measure)) return std::min(grade, Grade::kLarge);
  return finding.measure == MeasureKind::kTouching && grade != Grade::kRounding
             ? Grade::kWrongTouch
             : grade;
}

Grade GradeOf(const Invalidity& invalidity) {
  return invalidity.off_unit ? GradeOfShare(*invalidity.off_unit) : Grade::kUnusable;
}

}  // namespace touchstone
