#pragma once

#include <functional>

#include "reports/finding/finding.h"

namespace touchstone {

/** The changed copies of a world that a judgement needs, besides the one at half the step
 and those with a moved start. */
struct WantedNeighbours {
  bool quarter = true;                         ///< For the convergence and the limit.
  std::function<bool(MeasureKind)> variant{};  ///< All variants if empty.
};

}  // namespace touchstone
