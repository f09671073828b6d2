#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/dart_text.h"
#include "reports/reproduce/engine_code.h"
#include "reports/reproduce/midway_text.h"

namespace touchstone {
namespace {

std::string BodyText(char name, const Body& body) {
  return fmt::format(
      "  Eigen::Isometry3d X_{0} = Eigen::Isometry3d::Identity();\n"
      "  X_{0}.linear() << {1};\n"
      "  X_{0}.translation() << {2};\n"
      "  const auto frame_{0} = std::make_shared<dart::dynamics::SimpleFrame>(\n"
      "      dart::dynamics::Frame::World(), \"\", X_{0});\n"
      "  frame_{0}->setShape({3});\n"
      "  const auto {0} = detector->createCollisionGroup(frame_{0}.get());\n",
      name, Literals(body.X_WB.R_WB), Literals(body.X_WB.p_WB), DartShape(body.shape));
}

constexpr const char* kAsk = R"(
  const dart::collision::CollisionOption option(true, std::numeric_limits<int>::max());
  dart::collision::CollisionResult result;
  A->collide(B.get(), option, &result);
  std::printf("CollisionGroup::collide: %zu contacts\n", result.getNumContacts());
  Answer answer;
  answer.touching = result.getNumContacts() > 0;
  for (std::size_t i = 0; i < result.getNumContacts(); ++i) {{
    const dart::collision::Contact& c = result.getContact(i);
    std::printf("contact %zu: penetrationDepth %.17g, normal (%.17g, %.17g, %.17g), "
                "point (%.17g, %.17g, %.17g)\n", i, c.penetrationDepth, c.normal[0],
                c.normal[1], c.normal[2], c.point[0], c.point[1], c.point[2]);
    // DART's normal points to the first object.
    const Vector n = {{-c.normal[0], -c.normal[1], -c.normal[2]}};
    const double half = c.penetrationDepth / 2;
    const double shift = {};
    answer.contacts.push_back({{{{c.point[0] + shift * n[0], c.point[1] + shift * n[1],
                                c.point[2] + shift * n[2]}}, -c.penetrationDepth, n}});
    if (i > 0 && !(-c.penetrationDepth < answer.separation)) continue;
    answer.separation = -c.penetrationDepth;
    answer.n = n;
  }}
  return answer;
)";

/** Writes the shift from Contact::point to midway, see oracles/dart/dart_contacts.cc. */
std::string ShiftText(const ContactQuery& query) {
  const auto* const A = std::get_if<Sphere>(&query.A.shape);
  const auto* const B = std::get_if<Sphere>(&query.B.shape);
  if (A != nullptr && B != nullptr) {
    return fmt::format("c.penetrationDepth * {0} / ({0} + {1}) - half",
                       Literal(A->radius), Literal(B->radius));
  }
  if (A != nullptr || B != nullptr) return ShiftOfSphereAtBox(query);
  return "BestShift({0.0, -half, half}, {c.point[0], c.point[1], c.point[2]}, n, "
         "c.penetrationDepth)";
}

bool AreBoxes(const ContactQuery& query) {
  return std::holds_alternative<Box>(query.A.shape) &&
         std::holds_alternative<Box>(query.B.shape);
}

}  // namespace

EngineCode DartCode(const ContactQuery& query, const std::string&) {
  EngineCode code;
  code.includes =
      "#include <dart/collision/CollisionGroup.hpp>\n"
      "#include <dart/collision/dart/DARTCollisionDetector.hpp>\n"
      "#include <dart/dynamics/BoxShape.hpp>\n"
      "#include <dart/dynamics/SimpleFrame.hpp>\n"
      "#include <dart/dynamics/SphereShape.hpp>\n";
  code.ask =
      "  const auto detector = dart::collision::DARTCollisionDetector::create();\n" +
      BodyText('A', query.A) + BodyText('B', query.B) +
      fmt::format(kAsk, ShiftText(query));
  if (AreBoxes(query)) code.definitions = BestShiftText(query);
  code.find = FindDart();
  code.call = "CollisionGroup::collide of DARTCollisionDetector, all contacts";
  code.package = "libdart-dev";
  return code;
}

}  // namespace touchstone
