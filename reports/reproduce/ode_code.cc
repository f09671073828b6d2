#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/engine_code.h"
#include "reports/reproduce/ode_text.h"

namespace touchstone {
namespace {

std::string BodyText(char name, const Body& body) {
  const Eigen::Matrix3d& R = body.X_WB.R_WB;
  const Eigen::Vector3d& p = body.X_WB.p_WB;
  if (std::holds_alternative<HalfSpace>(body.shape)) {
    const Eigen::Vector3d n = R.col(2);
    return fmt::format("  const dGeomID {} = dCreatePlane(nullptr, {}, {});\n", name,
                       Literals(n), Literal(n.dot(p)));
  }
  const auto row = [&](int i) { return Literals(Eigen::Vector3d(R.row(i))); };
  return fmt::format(
      "  const dGeomID {0} = {1};\n"
      "  const dMatrix3 R_{0} = {{{2}, 0,\n      {3}, 0,\n      {4}, 0}};\n"
      "  dGeomSetRotation({0}, R_{0});\n"
      "  dGeomSetPosition({0}, {5});\n",
      name, OdeShape(body.shape), row(0), row(1), row(2), Literals(p));
}

constexpr const char* kAsk = R"(
  dContactGeom contacts[8];
  const int count = dCollide(A, B, 8, contacts, sizeof(dContactGeom));
  std::printf("dCollide: %d contacts\n", count);
  Answer answer;
  answer.touching = count > 0;
  for (int i = 0; i < count; ++i) {
    const dContactGeom& c = contacts[i];
    std::printf("contact %d: depth %.17g, normal (%.17g, %.17g, %.17g), "
                "pos (%.17g, %.17g, %.17g)\n", i, c.depth, c.normal[0], c.normal[1],
                c.normal[2], c.pos[0], c.pos[1], c.pos[2]);
    if (i > 0 && !(-c.depth < answer.separation)) continue;
    answer.separation = -c.depth;
    // ODE's normal points from the second geom to the first.
    answer.n = {-c.normal[0], -c.normal[1], -c.normal[2]};
  }
  return answer;
)";

}  // namespace

EngineCode OdeCode(const ContactQuery& query, const std::string&) {
  EngineCode code;
  code.includes = "#include <ode/ode.h>\n";
  code.ask = "  dInitODE2(0);\n" + BodyText('A', query.A) + BodyText('B', query.B) + kAsk;
  code.find = FindOde();
  code.call = "dCollide on two geoms, up to 8 contacts";
  code.package = "libode-dev";
  return code;
}

}  // namespace touchstone
