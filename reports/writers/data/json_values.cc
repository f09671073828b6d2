#include "reports/writers/data/json_values.h"

#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace touchstone {

DataJson ToData(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  // A whole number needs no ".0".
  if (value == std::trunc(value) && std::abs(value) < 1e15)
    return static_cast<std::int64_t>(value);
  return value;
}

DataJson ToData(double value, int digits) {
  if (!std::isfinite(value) || value == 0) return ToData(value);
  return ToData(std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr));
}

DataJson ToShare(double value) {
  constexpr double kMost = 1e9;
  return ToData(value <= kMost ? value : kMost, 5);
}

DataJson ToData(const Eigen::Vector3d& v, int digits) {
  return DataJson::array(
      {ToData(v.x(), digits), ToData(v.y(), digits), ToData(v.z(), digits)});
}

DataJson ToData(const Eigen::Quaterniond& q, int digits) {
  return DataJson::array({ToData(q.w(), digits), ToData(q.x(), digits),
                          ToData(q.y(), digits), ToData(q.z(), digits)});
}

}  // namespace touchstone
