#include "reports/text/format_vector.h"

#include <fmt/format.h>

namespace touchstone {

// Adding zero turns -0 into 0.

std::string FormatVector(const Eigen::Vector3d& v) {
  return fmt::format("({}, {}, {})", v.x() + 0.0, v.y() + 0.0, v.z() + 0.0);
}

std::string FormatVector(const Eigen::Vector3d& v, int digits) {
  return fmt::format("({:.{}g}, {:.{}g}, {:.{}g})", v.x() + 0.0, digits, v.y() + 0.0,
                     digits, v.z() + 0.0, digits);
}

}  // namespace touchstone
