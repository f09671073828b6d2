#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/engine_code.h"

namespace touchstone {
namespace {

constexpr const char* kDefinitions = R"(using Eigen::Vector3d;

struct Body {
  Eigen::Matrix3d R;
  Vector3d p;
  Vector3d centre;  // In the body's frame.
};

void Centre(const void* object, ccd_vec3_t* point) {
  const Body& body = *static_cast<const Body*>(object);
  const Vector3d p = body.R * body.centre + body.p;
  ccdVec3Set(point, p.x(), p.y(), p.z());
}

double Sign(double x) { return ccdSign(x); }

// The support point of a disc in the xy plane, as in libccd's own examples.
[[maybe_unused]] Vector3d OnDisc(double radius, const Vector3d& d) {
  const double length = std::hypot(d.x(), d.y());
  if (ccdIsZero(length)) return Vector3d::Zero();
  return {radius / length * d.x(), radius / length * d.y(), 0};
}
)";

/** Writes the body of the support function in the body's frame. `d` is the direction. */
struct Support {
  std::string operator()(const Sphere& s) const {
    return fmt::format("  return {} * d.normalized();\n", Literal(s.radius));
  }
  std::string operator()(const Box& s) const {
    return fmt::format(
        "  return Vector3d(Sign(d.x()), Sign(d.y()), Sign(d.z()))\n"
        "      .cwiseProduct(Vector3d({}));\n",
        Literals(s.half_extents));
  }
  std::string operator()(const Capsule& s) const {
    return fmt::format(
        "  return {} * d.normalized() + Sign(d.z()) * {} * Vector3d::UnitZ();\n",
        Literal(s.radius), Literal(s.half_length));
  }
  std::string operator()(const Cylinder& s) const {
    return fmt::format("  return OnDisc({}, d) + Sign(d.z()) * {} * Vector3d::UnitZ();\n",
                       Literal(s.radius), Literal(s.half_length));
  }
  std::string operator()(const Cone& s) const {
    return fmt::format(
        "  const Vector3d apex = {} * Vector3d::UnitZ();\n"
        "  const Vector3d rim = OnDisc({}, d) - apex;\n"
        "  return d.dot(apex) > d.dot(rim) ? apex : rim;\n",
        Literal(s.half_height), Literal(s.radius));
  }
  std::string operator()(const ConvexHull& s) const {
    std::string vertices;
    for (const Eigen::Vector3d& vertex : s.vertices)
      vertices += fmt::format("\n      {{{}}},", Literals(vertex));
    return fmt::format(
        "  static const std::vector<Vector3d> vertices = {{{}}};\n"
        "  const Vector3d* farthest = &vertices.front();\n"
        "  for (const Vector3d& v : vertices)\n"
        "    if (d.dot(v) > d.dot(*farthest)) farthest = &v;\n"
        "  return *farthest;\n",
        vertices);
  }
  std::string operator()(const HalfSpace&) const {
    throw CannotReproduce("libccd takes bounded shapes only");
  }
};

Eigen::Vector3d CentreOf(const Shape& shape) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const auto* hull = std::get_if<ConvexHull>(&shape);
  if (hull == nullptr) return sum;
  for (const Eigen::Vector3d& vertex : hull->vertices) sum += vertex;
  return sum / static_cast<double>(hull->vertices.size());
}

std::string SupportText(char name, const Body& body) {
  return fmt::format(
      "\nVector3d Local{0}(const Vector3d& d) {{\n{1}}}\n\n"
      "void Support{0}(const void* object, const ccd_vec3_t* direction,\n"
      "              ccd_vec3_t* point) {{\n"
      "  const Body& body = *static_cast<const Body*>(object);\n"
      "  const Vector3d d(ccdVec3X(direction), ccdVec3Y(direction), "
      "ccdVec3Z(direction));\n"
      "  const Vector3d d_B = body.R.transpose() * d;\n"
      "  const Vector3d p = body.R * Local{0}(d_B) + body.p;\n"
      "  ccdVec3Set(point, p.x(), p.y(), p.z());\n}}\n",
      name, std::visit(Support{}, body.shape));
}

std::string BodyText(char name, const Body& body) {
  return fmt::format(
      "  Body {0};\n  {0}.R << {1};\n  {0}.p << {2};\n  {0}.centre << {3};\n", name,
      Literals(body.X_WB.R_WB), Literals(body.X_WB.p_WB), Literals(CentreOf(body.shape)));
}

constexpr const char* kAsk = R"(
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = SupportA;
  ccd.support2 = SupportB;
  ccd.center1 = Centre;
  ccd.center2 = Centre;
  ccd.max_iterations = 500;
  ccd.epa_tolerance = 1e-6;
  ccd.mpr_tolerance = 1e-6;
  ccd_real_t depth = 0;
  ccd_vec3_t n{{}}, p{{}};
  const int status = {0}(&A, &B, &ccd, &depth, &n, &p);
  std::printf("{0}: returns %d, depth %.17g, dir (%.17g, %.17g, %.17g), "
              "pos (%.17g, %.17g, %.17g)\n", status, depth, ccdVec3X(&n), ccdVec3Y(&n),
              ccdVec3Z(&n), ccdVec3X(&p), ccdVec3Y(&p), ccdVec3Z(&p));
  Answer answer;
  answer.touching = status == 0;
  if (!answer.touching) return answer;
  answer.separation = -depth;
  answer.n = {{ccdVec3X(&n), ccdVec3Y(&n), ccdVec3Z(&n)}};
  answer.contacts.push_back(
      {{{{ccdVec3X(&p), ccdVec3Y(&p), ccdVec3Z(&p)}}, answer.separation, answer.n}});
  return answer;
)";

}  // namespace

EngineCode CcdCode(const ContactQuery& query, const std::string& oracle) {
  const char* const function =
      oracle == "libccd/epa" ? "ccdGJKPenetration" : "ccdMPRPenetration";
  EngineCode code;
  // libccd has no shapes. Its support functions are rounded as the adapter rounds them,
  // with Eigen, so that the answer is the same to the last bit.
  code.includes =
      "#include <vector>\n\n#include <Eigen/Geometry>\n#include <ccd/ccd.h>\n"
      "#include <ccd/vec3.h>\n";
  code.definitions = kDefinitions + SupportText('A', query.A) + SupportText('B', query.B);
  code.ask =
      BodyText('A', query.A) + BodyText('B', query.B) + fmt::format(kAsk, function);
  code.find =
      "find_package(PkgConfig REQUIRED)\n"
      "pkg_check_modules(ccd REQUIRED IMPORTED_TARGET ccd)\n"
      "find_package(Eigen3 REQUIRED NO_MODULE)\nadd_library(engine INTERFACE)\n"
      "target_link_libraries(engine INTERFACE PkgConfig::ccd Eigen3::Eigen)\n";
  code.call = fmt::format(
      "{} with max_iterations 500, epa_tolerance and mpr_tolerance 1e-6, and support "
      "functions like those of libccd's README",
      function);
  code.package = "libccd-dev libeigen3-dev";
  return code;
}

}  // namespace touchstone
