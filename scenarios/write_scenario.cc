#include <fmt/format.h>

#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

/** Returns the shortest decimal that reads back as the same double, sign of zero
 * included. */
std::string Number(double value) {
  std::string text = fmt::format("{}", value);
  // TOML would read an integer, whose -0 has no sign.
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string Vector(const Eigen::Vector3d& v) {
  return fmt::format("[{}, {}, {}]", Number(v[0]), Number(v[1]), Number(v[2]));
}

std::string Text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    switch (c) {
      case '"':
        quoted += "\\\"";
        break;
      case '\\':
        quoted += "\\\\";
        break;
      case '\n':
        quoted += "\\n";
        break;
      case '\r':
        quoted += "\\r";
        break;
      case '\t':
        quoted += "\\t";
        break;
      default: {
        const auto byte = static_cast<unsigned char>(c);
        const bool control = byte < 0x20 || byte == 0x7f;
        quoted += control ? fmt::format("\\u{:04X}", byte) : std::string(1, c);
      }
    }
  }
  return quoted + '"';
}

std::string Line(std::string_view key, std::string_view value) {
  return fmt::format("{} = {}\n", key, value);
}

std::string List(const std::vector<Eigen::Vector3d>& vectors) {
  std::string list = "[";
  for (const Eigen::Vector3d& v : vectors) list += fmt::format("\n  {},", Vector(v));
  return list + "\n]";
}

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

std::string BodyTable(std::string_view name, const Body& body) {
  return fmt::format("\n[bodies.{}]\n", name) +
         Line("shape", Text(NameOf(KindOf(body.shape)))) +
         std::visit(ShapeLines{}, body.shape) + PoseLines(body.X_WB);
}

std::string ExpectTable(const ContactExpectation& expect) {
  std::string lines;
  if (expect.touching) lines += Line("touching", *expect.touching ? "true" : "false");
  if (expect.separation) lines += Line("separation", Number(*expect.separation));
  if (!expect.normals.empty()) lines += Line("normals", List(expect.normals));
  if (expect.contacts) lines += Line("contacts", std::to_string(*expect.contacts));
  return lines.empty() ? lines : "\n[expect]\n" + lines;
}

std::string ToleranceTable(const ToleranceOverride& tolerance) {
  return "\n[tolerance]\n" + Line("separation", Number(tolerance.separation)) +
         Line("because", Text(tolerance.because));
}

std::string IndictmentTable(const Indictment& indictment) {
  return "\n[[indicts]]\n" + Line("oracle", Text(indictment.oracle)) +
         Line("anomaly", Text(indictment.anomaly)) +
         Line("reproduces", indictment.reproduces ? "true" : "false");
}

}  // namespace

std::string WriteScenario(const Scenario& scenario) {
  std::string file = Line("id", Text(scenario.id)) + Line("title", Text(scenario.title)) +
                     Line("source", Text(scenario.source)) +
                     BodyTable(scenario.name_A, scenario.contact.A) +
                     BodyTable(scenario.name_B, scenario.contact.B) + "\n[contact]\n" +
                     Line("A", Text(scenario.name_A)) + Line("B", Text(scenario.name_B)) +
                     ExpectTable(scenario.expect);
  if (scenario.tolerance) file += ToleranceTable(*scenario.tolerance);
  for (const Indictment& indictment : scenario.indicts)
    file += IndictmentTable(indictment);
  return file;
}

}  // namespace touchstone
