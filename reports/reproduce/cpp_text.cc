#include "reports/reproduce/cpp_text.h"

#include <fmt/format.h>

namespace touchstone {

std::string Literal(double x) {
  return fmt::format("{:#}", x);
}

std::string Literals(const Eigen::Vector3d& v) {
  return fmt::format("{}, {}, {}", Literal(v.x()), Literal(v.y()), Literal(v.z()));
}

std::string Literals(const Eigen::Matrix3d& R) {
  return fmt::format("{}, {}, {}", Literals(Eigen::Vector3d(R.row(0))),
                     Literals(Eigen::Vector3d(R.row(1))),
                     Literals(Eigen::Vector3d(R.row(2))));
}

std::string Quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    // An escaped question mark starts no trigraph.
    if (c == '"' || c == '\\' || c == '?') quoted += '\\';
    quoted += c == '\n' || c == '\r' ? ' ' : c;
  }
  return quoted + '"';
}

}  // namespace touchstone
