#pragma once

#include "reports/finding/finding.h"

namespace touchstone {

/** Returns whether a finding is a failure for which no cause has been found yet. */
inline bool IsUnexplained(const Finding& finding) {
  return IsProvedWrong(finding) && finding.cause == Cause::kNone;
}

}  // namespace touchstone
