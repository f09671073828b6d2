#include "reports/finding/grade.h"

namespace touchstone {

Grade GradeOfShare(double share) {
  // Written so that a NaN is gross.
  if (share <= kRoundingShare) return Grade::kRounding;
  if (share <= 1e-3) return Grade::kSmall;
  if (share <= 0.1) return Grade::kLarge;
  return Grade::kGross;
}

bool IsGraver(Grade fault, Grade above) {
  return fault == Grade::kNone || fault > above;
}

}  // namespace touchstone
