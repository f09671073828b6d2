#pragma once

#include <functional>

#include "reports/finding/finding.h"

namespace touchstone {

/** The changed copies of a world that a judgement needs, besides those with a moved
 start. Any of them needs the one at half the step, too. */
struct WantedNeighbours {
  /** A quarter of the step for claims that are judged by order or limit. */
  bool limit = true;
  /** A quarter of the step for the causes of failures. */
  bool causes = true;
  std::function<bool(MeasureKind)> variant{};  ///< All variants if empty.
};

}  // namespace touchstone
