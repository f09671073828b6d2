#include <cmath>

#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/mujoco_text.h"
#include "reports/reproduce/world_code.h"

namespace touchstone {
namespace {

constexpr const char* kModel = R"(
// Memory for that many contacts.
int contact_memory = 4 * kCount;

// The model in MJCF. Body b<i> is kBodies[i].
std::string Model() {
  const int rows = 4 * contact_memory;  // A contact has at most four.
  const int dofs = 6 * kCount;
  const int stack = 4 * dofs * dofs + rows * dofs + 200 * (rows + dofs);
  return "<mujoco><size nconmax=\"" + std::to_string(contact_memory) + "\" njmax=\"" +
         std::to_string(rows) + "\" nstack=\"" + std::to_string(stack) + R"("/>
)";

constexpr const char* kDefinitions = R"(
// MuJoCo's own handler waits for a key.
void Fail(const char* what) {
  std::fprintf(stderr, "%s\n", what);
  std::exit(2);
}
)";

constexpr const char* kMake = R"(  mju_user_error = &Fail;
  mju_user_warning = [](const char*) {};  // mjData counts them.
  const std::unique_ptr<mjModel, void (*)(mjModel*)> model(Load(Model()),
                                                           &mj_deleteModel);
  mjOption& option = model->opt;
  option.timestep = kStep;
  mju_copy3(option.gravity, kGravity.data());
)";

constexpr const char* kStart = R"(
  const std::unique_ptr<mjData, void (*)(mjData*)> data(mj_makeData(model.get()),
                                                        &mj_deleteData);
  // A body has its position and quaternion in qpos. In qvel it has its velocity in the
  // world frame and its spin in its own frame.
  mjtNum* positions[kCount] = {};
  mjtNum* velocities[kCount] = {};
  for (int i = 0; i < kCount; ++i) {
    const Body& asked = kBodies[i];
    if (asked.mass == 0) continue;
    const int body = mj_name2id(model.get(), mjOBJ_BODY, ("b" + std::to_string(i)).c_str());
    const int joint = model->body_jntadr[body];
    positions[i] = data->qpos + model->jnt_qposadr[joint];
    velocities[i] = data->qvel + model->jnt_dofadr[joint];
    mju_copy3(data->xfrc_applied + 6 * body, asked.force.data());
    mju_copy3(velocities[i], asked.v.data());
    mjtNum inverse[4];
    mju_negQuat(inverse, positions[i] + 3);
    mju_rotVecQuat(velocities[i] + 3, asked.w.data(), inverse);
  }
)";

constexpr const char* kStep = R"(      mj_step(model.get(), data.get());
      const auto warnings = [&](mjtWarning kind) { return data->warning[kind].number; };
      if (warnings(mjWARN_CONTACTFULL) + warnings(mjWARN_CNSTRFULL) > 0) {
        // MuJoCo has dropped contacts that do not fit: start over with more memory.
        contact_memory *= 2;
        return Simulate(wanted);
      }
      if (warnings(mjWARN_BADQPOS) + warnings(mjWARN_BADQVEL) + warnings(mjWARN_BADQACC) > 0)
        Fail("MuJoCo has reset the world: a number is NaN or too large");
)";

constexpr const char* kRead = R"(      const mjtNum* const p = positions[i];
      const mjtNum* const q = p + 3;
      const mjtNum* const v = velocities[i];
      mjtNum w[3];
      mju_rotVecQuat(w, v + 3, q);
      state[i] = {{p[0], p[1], p[2]},
                  Rotation(q[0], q[1], q[2], q[3]),
                  {v[0], v[1], v[2]},
                  {w[0], w[1], w[2]}};
)";

std::string Numbers(const Eigen::Vector3d& v) {
  return fmt::format("{} {} {}", v.x(), v.y(), v.z());
}

/** Returns the attributes of a shape; a hull is the mesh of the body's number. */
std::string GeomText(const Shape& shape, std::size_t i) {
  if (const auto* sphere = std::get_if<Sphere>(&shape))
    return fmt::format(R"(type="sphere" size="{}")", sphere->radius);
  if (const auto* box = std::get_if<Box>(&shape))
    return fmt::format(R"(type="box" size="{}")", Numbers(box->half_extents));
  if (const auto* capsule = std::get_if<Capsule>(&shape))
    return fmt::format(R"(type="capsule" size="{} {}")", capsule->radius,
                       capsule->half_length);
  if (const auto* cylinder = std::get_if<Cylinder>(&shape))
    return fmt::format(R"(type="cylinder" size="{} {}")", cylinder->radius,
                       cylinder->half_length);
  if (std::holds_alternative<ConvexHull>(shape))
    return fmt::format(R"(type="mesh" mesh="m{}")", i);
  return R"(type="plane" size="0 0 1")";
}

/** Returns the vertices of all hulls that collide, or nothing. */
std::string AssetText(const World& world) {
  std::string meshes;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const RigidBody& body = world.bodies[i];
    const auto* hull = std::get_if<ConvexHull>(&body.placed.shape);
    if (!hull || !body.collides) continue;
    std::string vertices;
    for (const Eigen::Vector3d& vertex : hull->vertices)
      vertices += Numbers(vertex) + "  ";
    meshes += fmt::format("    <mesh name=\"m{}\" vertex=\"{}\"/>\n", i, vertices);
  }
  return meshes.empty() ? "" : fmt::format("  <asset>\n{}  </asset>\n", meshes);
}

std::string PlaceText(const Pose& X_WB) {
  const Eigen::Quaterniond q = X_WB.q_WB ? *X_WB.q_WB : Eigen::Quaterniond(X_WB.R_WB);
  return fmt::format(R"(pos="{}" quat="{} {} {} {}")", Numbers(X_WB.p_WB), q.w(), q.x(),
                     q.y(), q.z());
}

// A contact of three dimensions has some friction even if the coefficient is zero.
int DimensionOf(double friction) {
  return friction > 0 ? 3 : 1;
}

std::string BodyText(std::size_t i, const RigidBody& body) {
  const bool moves = body.mass > 0;
  const std::string place = PlaceText(body.placed.X_WB);
  std::string geom;
  if (body.collides) {
    geom = fmt::format(R"(    <geom name="g{}" {} {}condim="{}" friction="{} 0 0"/>)", i,
                       GeomText(body.placed.shape, i), moves ? "" : place + " ",
                       DimensionOf(body.friction), body.friction) +
           "\n";
  }
  if (!moves) return geom;
  return fmt::format(
      "    <body name=\"b{}\" {}>\n"
      "      <freejoint/>\n"
      "      <inertial pos=\"0 0 0\" mass=\"{}\" diaginertia=\"{}\"/>\n"
      "{}{}    </body>\n",
      i, place, body.mass, Numbers(InertiaOf(body)), geom.empty() ? "" : "  ", geom);
}

/** Returns the pairs that may touch, with the friction of each. */
std::string PairsText(const World& world) {
  std::string pairs;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < world.bodies.size(); ++j) {
      const RigidBody& A = world.bodies[i];
      const RigidBody& B = world.bodies[j];
      if (!A.collides || !B.collides || (A.mass == 0 && B.mass == 0)) continue;
      const double mu = std::sqrt(A.friction * B.friction);
      pairs += fmt::format(
          "    <pair geom1=\"g{}\" geom2=\"g{}\" condim=\"{}\" friction=\"{} {} 0 0 "
          "0\"/>\n",
          i, j, DimensionOf(mu), mu, mu);
    }
  }
  return pairs;
}

std::string ModelText(const World& world) {
  bool one_friction = true;
  for (const RigidBody& body : world.bodies)
    one_friction &= body.friction == world.bodies.front().friction;
  // Without pairs MuJoCo takes the larger friction of two geoms.
  const std::string pairs = one_friction ? "" : PairsText(world);
  std::string text =
      fmt::format("{}  <option collision=\"{}\"/>\n{}  <worldbody>\n", kModel,
                  pairs.empty() ? "dynamic" : "predefined", AssetText(world));
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
    text += BodyText(i, world.bodies[i]);
  text += "  </worldbody>\n";
  if (!pairs.empty()) text += fmt::format("  <contact>\n{}  </contact>\n", pairs);
  return text + "</mujoco>)\";\n}\n";
}

/** Returns the stiffness of contacts with the time constant `time` [s]; with time 0, the
 stiffest that a step allows. */
std::string StiffnessText(double time, double impedance) {
  if (time > 0)
    return fmt::format(
        "option.o_solref[0] = {};\n  option.o_solref[1] = 1;  // Critically damped.",
        Literal(time));
  return fmt::format(
      "option.o_solref[0] = 0;  // Stiffness: none.\n"
      "  option.o_solref[1] = -{} / kStep;  // Damping.",
      Literal(impedance));
}

}  // namespace

EngineCode MujocoWorldCode(const World& world, const OracleInfo& oracle) {
  const char* const integrator =
      oracle.name == "mujoco/rk4" ? "mjINT_RK4" : "mjINT_EULER";
  const auto value = [&](const char* name) { return ValueOf(oracle, name); };
  SimulationText text;
  const auto set = [&](const char* name, const std::string& statement) {
    text.set_up += Explained(oracle, name, statement);
  };
  text.set_up = fmt::format(
      "{}  option.integrator = {};\n"
      "  option.enableflags |= mjENBL_OVERRIDE;  // o_* are for all contacts.\n",
      kMake, integrator);
  set("elliptic_cone",
      fmt::format("option.cone = {};",
                  value("elliptic_cone") != 0 ? "mjCONE_ELLIPTIC" : "mjCONE_PYRAMIDAL"));
  set("solver_tolerance",
      fmt::format("option.tolerance = {};", Literal(value("solver_tolerance"))));
  set("iterations",
      fmt::format("option.iterations = {};", static_cast<int>(value("iterations"))));
  set("least_impedance",
      fmt::format("option.o_solimp[0] = {};", Literal(value("least_impedance"))));
  set("impedance", fmt::format("option.o_solimp[1] = {};", Literal(value("impedance"))));
  set("contact_time", StiffnessText(value("contact_time"), value("impedance")));
  set("margin", fmt::format("option.o_margin = {};", Literal(value("margin"))));
  text.set_up += IfChanged(oracle, "noslip_iterations",
                           fmt::format("option.noslip_iterations = {};",
                                       static_cast<int>(value("noslip_iterations"))));
  text.set_up +=
      IfChanged(oracle, "impratio",
                fmt::format("option.impratio = {};", Literal(value("impratio"))));
  text.set_up += kStart;
  text.step = kStep;
  text.read = kRead;
  EngineCode code;
  code.includes = MujocoIncludes();
  code.definitions = kDefinitions + LoadMujocoModel() + ModelText(world);
  code.ask = SimulateText(text);
  code.find = FindMujoco();
  code.call = fmt::format("mj_step with the integrator {}", integrator);
  code.package = "libmujoco-dev";
  return code;
}

}  // namespace touchstone
