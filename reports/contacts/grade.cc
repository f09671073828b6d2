#include "reports/contacts/grade.h"

#include "reports/contacts/body_size.h"
#include "reports/measures/outside.h"

namespace touchstone {
namespace {

constexpr double kRoundingSize = 1e-6;

Grade GradeOf(double size) {
  // Written so that a NaN is gross.
  if (size <= kRoundingSize) return Grade::kRounding;
  if (size <= 1e-3) return Grade::kSmall;
  if (size <= 0.1) return Grade::kLarge;
  return Grade::kGross;
}

}  // namespace

Grade GradeOf(const Finding& finding, const ContactQuery& query,
              const ContactTruth& truth) {
  const double body = SmallerExtent(query);
  if (finding.measure == MeasureKind::kTouching) {
    return Outside(0, truth.separation) <= kRoundingSize * body ? Grade::kRounding
                                                                : Grade::kWrongTouch;
  }
  return GradeOf(UnitOf(finding.measure) == "m" ? finding.value / body : finding.value);
}

}  // namespace touchstone
