#include "reports/finding/severity.h"

namespace touchstone {

int SeverityOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass:
      return 0;
    case Verdict::kUndecidable:
      return 1;
    case Verdict::kFail:
    case Verdict::kDisagree:
    case Verdict::kKnown:
      return 2;
    case Verdict::kInvalid:
    case Verdict::kCrashed:
    case Verdict::kTimedOut:
      return 3;
    case Verdict::kUnsupported:
      return 4;
  }
  return 4;
}

Verdict Worse(Verdict a, Verdict b) {
  return SeverityOf(b) > SeverityOf(a) ? b : a;
}

}  // namespace touchstone
