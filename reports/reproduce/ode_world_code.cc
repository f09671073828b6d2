#include <utility>

#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/ode_text.h"
#include "reports/reproduce/world_code.h"

namespace touchstone {
namespace {

constexpr const char* kCollide = R"(
// The contacts of a step, and their forces. ODE keeps pointers to the forces.
struct Contacts {
  dWorldID world;
  dJointGroupID joints;
  std::deque<dJointFeedback> forces;
};

// The callback of dSpaceCollide for two geoms that may touch.
void Collide(void* data, dGeomID a, dGeomID b) {
  Contacts& contacts = *static_cast<Contacts*>(data);
  if (dGeomGetBody(a) == nullptr && dGeomGetBody(b) == nullptr) return;
  dContactGeom geoms[8];  // The most that ODE returns for two boxes.
  const int count = dCollide(a, b, 8, geoms, sizeof(dContactGeom));
  const Body& A = *static_cast<const Body*>(dGeomGetData(a));
  const Body& B = *static_cast<const Body*>(dGeomGetData(b));
  dContact contact{};
  contact.surface.mode = dContactBounce | dContactApprox1 | dContactSoftERP;
  contact.surface.mu = std::sqrt(A.friction * B.friction);
  contact.surface.bounce = std::min(A.restitution, B.restitution);
)";

constexpr const char* kJoints = R"(  for (int i = 0; i < count; ++i) {
    contact.geom = geoms[i];
    const dJointID joint = dJointCreateContact(contacts.world, contacts.joints, &contact);
    dJointAttach(joint, dGeomGetBody(contact.geom.g1), dGeomGetBody(contact.geom.g2));
    // Reading the force may change how the solver's sums are rounded.
    dJointSetFeedback(joint, &contacts.forces.emplace_back());
  }
}
)";

constexpr const char* kSetUp = R"(  dInitODE2(0);
  const dThreadingImplementationID threading =
      dThreadingAllocateSelfThreadedImplementation();  // The calling thread alone.
  const dWorldID world = dWorldCreate();
  Contacts contacts{world, dJointGroupCreate(0), {}};
  const dSpaceID space = dHashSpaceCreate(nullptr);  // The broad phase.
  dWorldSetStepThreadingImplementation(
      world, dThreadingImplementationGetFunctions(threading), threading);
  dWorldSetGravity(world, kGravity[0], kGravity[1], kGravity[2]);
)";

constexpr const char* kBodies = R"(
  dBodyID bodies[kCount] = {};
  for (int i = 0; i < kCount; ++i) {
    const Body& asked = kBodies[i];
    const Matrix& R = asked.R;
    const dMatrix3 rows = {R[0], R[1], R[2], 0, R[3], R[4], R[5], 0, R[6], R[7], R[8], 0};
    dBodyID body = nullptr;
    if (asked.mass > 0) {
      body = bodies[i] = dBodyCreate(world);
      dMass mass;
      dMassSetParameters(&mass, asked.mass, 0, 0, 0, asked.I[0], asked.I[1], asked.I[2],
                         0, 0, 0);
      dBodySetMass(body, &mass);
      dBodySetRotation(body, rows);
      dBodySetPosition(body, asked.p[0], asked.p[1], asked.p[2]);
      dBodySetLinearVel(body, asked.v[0], asked.v[1], asked.v[2]);
      dBodySetAngularVel(body, asked.w[0], asked.w[1], asked.w[2]);
    }
    const dGeomID geom = geoms[i];
    if (geom == nullptr) continue;
    if (dGeomGetClass(geom) != dPlaneClass) {
      dGeomSetRotation(geom, rows);
      dGeomSetPosition(geom, asked.p[0], asked.p[1], asked.p[2]);
    }
    if (body != nullptr) dGeomSetBody(geom, body);
    dGeomSetData(geom, const_cast<Body*>(&asked));
    dSpaceAdd(space, geom);
  }
)";

constexpr const char* kStep = R"(      for (int i = 0; i < kCount; ++i) {
        const Vector& f = kBodies[i].force;
        if (bodies[i] != nullptr) dBodyAddForce(bodies[i], f[0], f[1], f[2]);
      }
      dJointGroupEmpty(contacts.joints);
      contacts.forces.clear();
      dSpaceCollide(space, &contacts, &Collide);
)";

constexpr const char* kRead = R"(      const dReal* const p = dBodyGetPosition(bodies[i]);
      const dReal* const q = dBodyGetQuaternion(bodies[i]);
      const dReal* const v = dBodyGetLinearVel(bodies[i]);
      const dReal* const w = dBodyGetAngularVel(bodies[i]);
      state[i] = {{p[0], p[1], p[2]},
                  Rotation(q[0], q[1], q[2], q[3]),
                  {v[0], v[1], v[2]},
                  {w[0], w[1], w[2]}};
)";

constexpr const char* kCleanUp = R"(  dJointGroupDestroy(contacts.joints);
  dSpaceDestroy(space);
  dWorldDestroy(world);
  dThreadingFreeImplementation(threading);
  dCloseODE();
)";

std::string GeomText(const RigidBody& body) {
  if (!body.collides) return "nullptr";
  if (!std::holds_alternative<HalfSpace>(body.placed.shape))
    return OdeShape(body.placed.shape);
  const Eigen::Vector3d n = body.placed.X_WB.R_WB.col(2);
  return fmt::format("dCreatePlane(nullptr, {}, {})", Literals(n),
                     Literal(n.dot(body.placed.X_WB.p_WB)));
}

}  // namespace

EngineCode OdeWorldCode(const World& world, const OracleInfo& oracle) {
  const bool is_quick = oracle.name == "ode/quick";
  const auto set = [&](const char* name, const char* statement) {
    return Explained(
        oracle, name,
        fmt::format(fmt::runtime(statement), Literal(ValueOf(oracle, name))));
  };
  const auto if_changed = [&](const char* name, const char* statement) {
    return IfChanged(
        oracle, name,
        fmt::format(fmt::runtime(statement), Literal(ValueOf(oracle, name))));
  };
  EngineCode code;
  code.includes = "#include <deque>\n\n#include <ode/ode.h>\n";
  code.definitions = kCollide +
                     set("restitution_threshold", "contact.surface.bounce_vel = {};") +
                     set("contact_erp", "contact.surface.soft_erp = {};") +
                     if_changed("rolling_friction",
                                "contact.surface.mode |= dContactRolling;\n"
                                "  contact.surface.rho = contact.surface.rho2 = {};") +
                     if_changed("spinning_friction",
                                "contact.surface.mode |= dContactRolling;\n"
                                "  contact.surface.rhoN = {};") +
                     kJoints;
  SimulationText text;
  text.set_up = kSetUp + set("joint_erp", "dWorldSetERP(world, {});") +
                set("cfm", "dWorldSetCFM(world, {});") +
                if_changed("surface_layer", "dWorldSetContactSurfaceLayer(world, {});") +
                if_changed("max_correcting_velocity",
                           "dWorldSetContactMaxCorrectingVel(world, {});");
  if (is_quick) {
    text.set_up +=
        Explained(oracle, "iterations",
                  fmt::format("dWorldSetQuickStepNumIterations(world, {});",
                              static_cast<int>(ValueOf(oracle, "iterations"))));
    text.set_up +=
        "  dRandSetSeed(0);  // QuickStep solves the contacts in random order.\n";
  }
  text.set_up += "  const dGeomID geoms[kCount] = {\n";
  for (const RigidBody& body : world.bodies)
    text.set_up += fmt::format("      {},\n", GeomText(body));
  text.set_up += fmt::format("  }};\n{}", kBodies);
  for (const auto& [name, setter] :
       {std::pair("gyroscopic", "dBodySetGyroscopicMode"),
        std::pair("finite_rotation", "dBodySetFiniteRotationMode")}) {
    text.set_up +=
        IfChanged(oracle, name,
                  fmt::format("for (const dBodyID body : bodies)\n"
                              "    if (body != nullptr) {}(body, {});",
                              setter, static_cast<int>(ValueOf(oracle, name))));
  }
  const char* const stepper = is_quick ? "dWorldQuickStep" : "dWorldStep";
  text.step = fmt::format("{}      {}(world, kStep);\n", kStep, stepper);
  text.read = kRead;
  text.clean_up = kCleanUp;
  code.ask = SimulateText(text);
  code.find = FindOde();
  code.call = fmt::format("{}, after dSpaceCollide on a dHashSpace", stepper);
  code.package = "libode-dev";
  return code;
}

}  // namespace touchstone
