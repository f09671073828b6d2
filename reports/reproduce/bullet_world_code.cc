#include <array>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "reports/reproduce/bullet_text.h"
#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/world_code.h"

namespace touchstone {
namespace {

constexpr const char* kIncludes =
    "#include <btBulletDynamicsCommon.h>\n"
    "#include <BulletCollision/CollisionDispatch/btManifoldResult.h>\n";

constexpr const char* kDefinitions = R"(
// Bullet's own rules are the products.
btScalar Restitution(const btCollisionObject* A, const btCollisionObject* B) {
  return std::min(A->getRestitution(), B->getRestitution());
}
btScalar Friction(const btCollisionObject* A, const btCollisionObject* B) {
  return btSqrt(A->getFriction() * B->getFriction());
}

btVector3 ToBullet(const Vector& v) {
  return {btScalar(v[0]), btScalar(v[1]), btScalar(v[2])};
}
Vector FromBullet(const btVector3& v) { return {v[0], v[1], v[2]}; }
)";

constexpr const char* kBodies = R"(
  // Collision filters: static bodies do not collide with each other.
  enum Group { kNobody = 0, kMoving = 1, kStatic = 2 };
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  gCalculateCombinedRestitutionCallback = &Restitution;
  gCalculateCombinedFrictionCallback = &Friction;
  world.setGravity(ToBullet(kGravity));
  for (int i = 0; i < kCount; ++i) {
    const Body& asked = kBodies[i];
    const Matrix& R = asked.R;
    btRigidBody::btRigidBodyConstructionInfo construction(
        btScalar(asked.mass), nullptr, shapes[i], ToBullet(asked.I));
    construction.m_startWorldTransform = btTransform(
        btMatrix3x3(btScalar(R[0]), btScalar(R[1]), btScalar(R[2]), btScalar(R[3]),
                    btScalar(R[4]), btScalar(R[5]), btScalar(R[6]), btScalar(R[7]),
                    btScalar(R[8])),
        ToBullet(asked.p));
    construction.m_restitution = btScalar(asked.restitution);
    construction.m_friction = btScalar(asked.friction);
    bodies.push_back(std::make_unique<btRigidBody>(construction));
    btRigidBody& body = *bodies.back();
    body.setActivationState(DISABLE_DEACTIVATION);  // No sleeping.
    const bool moves = asked.mass > 0;
    if (moves) {
      body.setLinearVelocity(ToBullet(asked.v));
      body.setAngularVelocity(ToBullet(asked.w));
    }
    const int group = !asked.collides ? kNobody : moves ? kMoving : kStatic;
    const int meets = !asked.collides ? kNobody : moves ? kMoving | kStatic : kMoving;
    world.addRigidBody(&body, group, meets);
  }
  btContactSolverInfo& info = world.getSolverInfo();
)";

constexpr const char* kStep = R"(      for (int i = 0; i < kCount; ++i)
        bodies[i]->applyCentralForce(ToBullet(kBodies[i].force));
      world.stepSimulation(btScalar(kStep), 0);  // 0: one step of exactly that length.
)";

constexpr const char* kRead = R"(      const btRigidBody& body = *bodies[i];
      const btQuaternion q = body.getOrientation();
      state[i] = {FromBullet(body.getCenterOfMassPosition()),
                  Rotation(q.w(), q.x(), q.y(), q.z()),
                  FromBullet(body.getLinearVelocity()),
                  FromBullet(body.getAngularVelocity())};
)";

constexpr const char* kCleanUp =
    "  for (const auto& body : bodies) world.removeRigidBody(body.get());\n";

}  // namespace

EngineCode BulletWorldCode(const World& world, const OracleInfo& oracle) {
  EngineCode code;
  code.includes = kIncludes;
  code.definitions = kDefinitions;
  SimulationText text;
  std::string shapes;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const std::string name = fmt::format("shape_{}", i);
    text.set_up += DefineBulletShape(name, world.bodies[i].placed.shape);
    shapes += fmt::format("      &{},\n", name);
  }
  const auto value = [&](const char* name) { return ValueOf(oracle, name); };
  const auto whole = [&](const char* name) { return static_cast<int>(value(name)); };
  const auto set = [&](const char* name, const std::string& statement) {
    text.set_up += Explained(oracle, name, statement);
  };
  text.set_up += fmt::format("  btCollisionShape* const shapes[kCount] = {{\n{}  }};\n{}",
                             shapes, kBodies);
  set("iterations", fmt::format("info.m_numIterations = {};", whole("iterations")));
  set("residual", fmt::format("info.m_leastSquaresResidualThreshold = {0} * {0};",
                              BulletScalar(value("residual"))));
  set("erp", fmt::format("info.m_erp = info.m_erp2 = {};", BulletScalar(value("erp"))));
  set("split_impulse",
      fmt::format("info.m_splitImpulse = {};", value("split_impulse") != 0 ? 1 : 0));
  set("friction_directions",
      value("friction_directions") == 2
          ? "info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;"
          : "// One direction.");
  set("restitution_threshold", fmt::format("info.m_restitutionVelocityThreshold = {};",
                                           BulletScalar(value("restitution_threshold"))));
  set("processing_threshold", fmt::format("for (const auto& body : bodies)\n"
                                          "    body->setContactProcessingThreshold({});",
                                          BulletScalar(value("processing_threshold"))));
  const auto set_each = [&](const char* name, const char* setter,
                            const std::string& argument) {
    text.set_up += IfChanged(
        oracle, name,
        fmt::format("for (const auto& body : bodies) body->{}({});", setter, argument));
  };
  for (const auto& [name, setter] :
       {std::pair("ccd_threshold", "setCcdMotionThreshold"),
        std::pair("ccd_radius", "setCcdSweptSphereRadius"),
        std::pair("rolling_friction", "setRollingFriction"),
        std::pair("spinning_friction", "setSpinningFriction")}) {
    set_each(name, setter, BulletScalar(value(name)));
  }
  constexpr std::array<const char*, 4> kGyroscopic = {
      "0", "BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT",
      "BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD",
      "BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY"};
  set_each("gyroscopic", "setFlags",
           kGyroscopic[static_cast<std::size_t>(whole("gyroscopic"))]);
  text.step = kStep;
  text.read = kRead;
  text.clean_up = kCleanUp;
  code.ask = SimulateText(text);
  code.find = FindBullet(oracle.name);
  code.call = fmt::format(
      "btDiscreteDynamicsWorld::stepSimulation with btDbvtBroadphase and "
      "btSequentialImpulseConstraintSolver, the build {}",
      BulletBuild(oracle.name));
  code.package = "libbullet-dev";
  return code;
}

}  // namespace touchstone
