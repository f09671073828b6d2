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

std::string InBodyFrame(const Pose& X_WB) {
  const Eigen::Vector3d& p = X_WB.p_WB;
  const auto along = [&](int axis) {
    const Eigen::Vector3d e_W = X_WB.R_WB.col(axis);
    return fmt::format("{} * u + {} * v + {} * w", Literal(e_W.x()), Literal(e_W.y()),
                       Literal(e_W.z()));
  };
  return fmt::format(
      "  u -= {};\n  v -= {};\n  w -= {};\n"
      "  const double x = {};\n  const double y = {};\n  const double z = {};\n",
      Literal(p.x()), Literal(p.y()), Literal(p.z()), along(0), along(1), along(2));
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
