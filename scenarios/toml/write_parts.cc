#include "scenarios/toml/write_parts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scenarios/toml/toml_text.h"

namespace touchstone {
namespace {

using toml_text::Line;
using toml_text::List;
using toml_text::Number;
using toml_text::Text;
using toml_text::Truth;
using toml_text::Vector;

struct ShapeLines {
  std::string operator()(const Sphere& sphere) const {
    return Line("radius", Number(sphere.radius));
  }
  std::string operator()(const Box& box) const {
    return Line("half_extents", Vector(box.half_extents));
  }
  std::string operator()(const Capsule& capsule) const {
    return Line("radius", Number(capsule.radius)) +
           Line("half_length", Number(capsule.half_length));
  }
  std::string operator()(const Cylinder& cylinder) const {
    return Line("radius", Number(cylinder.radius)) +
           Line("half_length", Number(cylinder.half_length));
  }
  std::string operator()(const Cone& cone) const {
    return Line("radius", Number(cone.radius)) +
           Line("half_height", Number(cone.half_height));
  }
  std::string operator()(const ConvexHull& hull) const {
    return Line("vertices", List(hull.vertices));
  }
  std::string operator()(const HalfSpace&) const { return ""; }
};

std::string NamesOf(const std::vector<MeasureKind>& measures) {
  std::vector<std::string> names;
  for (const MeasureKind measure : measures) names.push_back(Text(NameOf(measure)));
  return fmt::format("[{}]", fmt::join(names, ", "));
}

std::string PoseLines(const Pose& pose) {
  const std::string position = Line("position", Vector(pose.p_WB));
  if (pose.q_WB) {
    return position +
           Line("quaternion", fmt::format("[{}, {}, {}, {}]", Number(pose.q_WB->w()),
                                          Number(pose.q_WB->x()), Number(pose.q_WB->y()),
                                          Number(pose.q_WB->z())));
  }
  const Eigen::Matrix3d& R = pose.R_WB;
  return position + Line("rotation", List({R.row(0), R.row(1), R.row(2)}));
}

}  // namespace

std::string HeadingLines(std::string_view id, std::string_view title,
                         std::string_view source) {
  return Line("id", Text(id)) + Line("title", Text(title)) + Line("source", Text(source));
}

std::string BodyLines(const Body& body) {
  return Line("shape", Text(NameOf(KindOf(body.shape)))) +
         std::visit(ShapeLines{}, body.shape) + PoseLines(body.X_WB);
}

std::string IndictmentTables(const std::vector<Indictment>& indictments) {
  std::string tables;
  for (const Indictment& indictment : indictments) {
    tables += "\n[[indicts]]\n" + Line("oracle", Text(indictment.oracle)) +
              Line("measures", NamesOf(indictment.measures)) +
              Line("anomaly", Text(indictment.anomaly)) +
              Line("reproduces", Truth(indictment.reproduces));
  }
  return tables;
}

}  // namespace touchstone
