#include "tests/scenarios/contact_table_text.h"

#include <fmt/format.h>

namespace touchstone {
namespace {

/** The cells of sizes: radius, half_extents, half_length, half_height, vertices. */
struct SizeCells {
  std::string operator()(const Sphere& sphere) const {
    return fmt::format("{},,,,,,", sphere.radius);
  }
  std::string operator()(const Box& box) const {
    return fmt::format(",{},{},{},,,", box.half_extents.x(), box.half_extents.y(),
                       box.half_extents.z());
  }
  std::string operator()(const Capsule& capsule) const {
    return fmt::format("{},,,,{},,", capsule.radius, capsule.half_length);
  }
  std::string operator()(const Cylinder& cylinder) const {
    return fmt::format("{},,,,{},,", cylinder.radius, cylinder.half_length);
  }
  std::string operator()(const Cone& cone) const {
    return fmt::format("{},,,,,{},", cone.radius, cone.half_height);
  }
  std::string operator()(const ConvexHull& hull) const {
    std::string vertices;
    for (const Eigen::Vector3d& v : hull.vertices) {
      vertices +=
          fmt::format("{}{} {} {}", vertices.empty() ? "" : " ", v.x(), v.y(), v.z());
    }
    return ",,,,,," + vertices;
  }
  std::string operator()(const HalfSpace&) const { return ",,,,,,"; }
};

std::string CellsOf(const Body& body) {
  const Eigen::Vector3d& p_WB = body.X_WB.p_WB;
  const Eigen::Quaterniond& q_WB = body.X_WB.q_WB.value();
  return fmt::format("{},{},{},{},{},{},{},{},{}", NameOf(KindOf(body.shape)),
                     std::visit(SizeCells{}, body.shape), p_WB.x(), p_WB.y(), p_WB.z(),
                     q_WB.w(), q_WB.x(), q_WB.y(), q_WB.z());
}

std::string ColumnsOf(char body) {
  std::string columns;
  for (const char* column :
       {"shape", "radius", "half_extents.x", "half_extents.y", "half_extents.z",
        "half_length", "half_height", "vertices", "position.x", "position.y",
        "position.z", "quaternion.w", "quaternion.x", "quaternion.y", "quaternion.z"})
    columns += fmt::format("{}{}.{}", columns.empty() ? "" : ",", body, column);
  return columns;
}

}  // namespace

std::string ContactTableText(std::span<const Scenario> scenarios) {
  std::string text = fmt::format("{},{}\n", ColumnsOf('A'), ColumnsOf('B'));
  for (const Scenario& scenario : scenarios)
    text +=
        fmt::format("{},{}\n", CellsOf(scenario.contact.A), CellsOf(scenario.contact.B));
  return text;
}

}  // namespace touchstone
