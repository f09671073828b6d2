#include "reports/worlds/law_support/slop.h"

#include <fmt/format.h>

namespace touchstone {

std::string WithSlop(std::string because, const OracleInfo& oracle) {
  if (oracle.slop == 0) return because;
  return fmt::format("{}; it includes the slop of {:.3g} m documented by {}", because,
                     oracle.slop, oracle.slop_documented_by);
}

}  // namespace touchstone
