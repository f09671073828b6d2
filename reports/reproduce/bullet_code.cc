#include <fmt/format.h>

#include "reports/reproduce/bullet_text.h"
#include "reports/reproduce/engine_code.h"

namespace touchstone {
namespace {

std::string BodyText(char name, const Body& body) {
  std::string entries;
  for (int i = 0; i < 9; ++i) {
    entries += fmt::format("{}{}", i == 0 ? "" : ", ",
                           BulletScalar(body.X_WB.R_WB(i / 3, i % 3)));
  }
  return DefineBulletShape(std::string(1, name), body.shape) +
         fmt::format("  const btTransform X_{}(btMatrix3x3({}),\n      {});\n", name,
                     entries, BulletVector(body.X_WB.p_WB));
}

constexpr const char* kGjkDefinitions =
    R"(struct Reported : btDiscreteCollisionDetectorInterface::Result {
  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3& normal, const btVector3& point,
                       btScalar d) override {
    reported = true;
    normal_on_B = normal;
    point_on_B = point;
    distance = d;
  }
  bool reported = false;
  btVector3 normal_on_B{0, 0, 0}, point_on_B{0, 0, 0};
  btScalar distance = 0;
};
)";

constexpr const char* kGjk = R"(
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btGjkPairDetector detector(&A, &B, &simplex, &depth);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = X_A;
  input.m_transformB = X_B;
  Reported r;
  detector.getClosestPoints(input, r, nullptr);
  Answer answer;
  if (!r.reported) {
    std::printf("btGjkPairDetector: no point\n");
    return answer;
  }
  const btVector3& n = r.normal_on_B;
  const btVector3& p = r.point_on_B;
  std::printf("btGjkPairDetector: distance %.17g, normal on B (%.17g, %.17g, %.17g), "
              "point on B (%.17g, %.17g, %.17g)\n", double(r.distance), double(n[0]),
              double(n[1]), double(n[2]), double(p[0]), double(p[1]), double(p[2]));
  answer.separation = r.distance;
  answer.touching = answer.separation <= 0;
  for (int i = 0; i < 3; ++i) {
    answer.n[i] = -double(n[i]);
    answer.b[i] = p[i];
    answer.a[i] = double(p[i]) + double(n[i]) * answer.separation;
  }
  return answer;
)";

constexpr const char* kDispatch = R"(
  btCollisionObject object_A, object_B;
  object_A.setCollisionShape(&A);
  object_A.setWorldTransform(X_A);
  object_B.setCollisionShape(&B);
  object_B.setWorldTransform(X_B);
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  const btCollisionObjectWrapper a(nullptr, &A, &object_A, X_A, -1, -1);
  const btCollisionObjectWrapper b(nullptr, &B, &object_B, X_B, -1, -1);
  btCollisionAlgorithm* const algorithm =
      dispatcher.findAlgorithm(&a, &b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
  btManifoldResult result(&a, &b);
  algorithm->processCollision(&a, &b, btDispatcherInfo(), &result);
  Answer answer;
  bool any = false;
  for (int m = 0; m < dispatcher.getNumManifolds(); ++m) {
    const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(m);
    const double sign = manifold.getBody0() == &object_A ? -1 : 1;
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
      const btManifoldPoint& c = manifold.getContactPoint(i);
      const btVector3& n = c.m_normalWorldOnB;
      const btVector3& on_A = c.getPositionWorldOnA();
      const btVector3& on_B = c.getPositionWorldOnB();
      std::printf("contact %d: distance %.17g, m_normalWorldOnB (%.17g, %.17g, %.17g), "
                  "getPositionWorldOnA (%.17g, %.17g, %.17g), "
                  "getPositionWorldOnB (%.17g, %.17g, %.17g)\n", i,
                  double(c.getDistance()), double(n[0]), double(n[1]), double(n[2]),
                  double(on_A[0]), double(on_A[1]), double(on_A[2]), double(on_B[0]),
                  double(on_B[1]), double(on_B[2]));
      Contact contact;
      contact.s = c.getDistance();
      for (int k = 0; k < 3; ++k) {
        contact.p[k] = (double(on_A[k]) + double(on_B[k])) / 2;
        contact.n[k] = sign * n[k];
      }
      answer.contacts.push_back(contact);
      if (any && !(c.getDistance() < answer.separation)) continue;
      any = true;
      answer.separation = c.getDistance();
      answer.n = {sign * n[0], sign * n[1], sign * n[2]};
    }
  }
  if (!any) std::printf("processCollision: no contact\n");
  answer.touching = any && answer.separation <= 0;
  // A manifold also holds points of bodies that are apart.
  if (!answer.touching) answer.contacts.clear();
  // The dispatcher's pool hands out raw memory.
  algorithm->~btCollisionAlgorithm();
  dispatcher.freeCollisionAlgorithm(algorithm);
  return answer;
)";

}  // namespace

EngineCode BulletCode(const ContactQuery& query, const std::string& oracle) {
  const bool gjk = oracle.ends_with("/gjk");
  EngineCode code;
  code.includes = gjk ? "#include <btBulletCollisionCommon.h>\n"
                        "#include <BulletCollision/NarrowPhaseCollision/"
                        "btGjkEpaPenetrationDepthSolver.h>\n"
                        "#include <BulletCollision/NarrowPhaseCollision/"
                        "btGjkPairDetector.h>\n"
                      : "#include <btBulletCollisionCommon.h>\n"
                        "#include <BulletCollision/CollisionDispatch/"
                        "btCollisionObjectWrapper.h>\n";
  code.definitions = gjk ? kGjkDefinitions : "";
  code.ask = BodyText('A', query.A) + BodyText('B', query.B) + (gjk ? kGjk : kDispatch);
  code.find = FindBullet(oracle);
  code.call = fmt::format("{}, margins 0, the build {}",
                          gjk ? "btGjkPairDetector with btGjkEpaPenetrationDepthSolver"
                              : "the algorithm that btCollisionDispatcher finds for "
                                "BT_CONTACT_POINT_ALGORITHMS, once on an empty manifold",
                          BulletBuild(oracle));
  code.package = "libbullet-dev";
  return code;
}

}  // namespace touchstone
