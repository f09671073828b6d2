#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/dart_text.h"
#include "reports/reproduce/engine_code.h"

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
  for (std::size_t i = 0; i < result.getNumContacts(); ++i) {
    const dart::collision::Contact& c = result.getContact(i);
    std::printf("contact %zu: penetrationDepth %.17g, normal (%.17g, %.17g, %.17g), "
                "point (%.17g, %.17g, %.17g)\n", i, c.penetrationDepth, c.normal[0],
                c.normal[1], c.normal[2], c.point[0], c.point[1], c.point[2]);
    if (i > 0 && !(-c.penetrationDepth < answer.separation)) continue;
    answer.separation = -c.penetrationDepth;
    // DART's normal points to the first object.
    answer.n = {-c.normal[0], -c.normal[1], -c.normal[2]};
  }
  return answer;
)";

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
      BodyText('A', query.A) + BodyText('B', query.B) + kAsk;
  code.find = FindDart();
  code.call = "CollisionGroup::collide of DARTCollisionDetector, all contacts";
  code.package = "libdart-dev";
  return code;
}

}  // namespace touchstone
