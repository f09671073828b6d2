#include "reports/reproduce/world_code.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "oracles/world_setup.h"
#include "reports/reproduce/cpp_text.h"
#include "reports/text/commented.h"
#include "reports/writers/describe.h"

namespace touchstone {
namespace {

constexpr const char* kTypes = R"(// A matrix, row by row.
using Matrix = std::array<double, 9>;

struct Body {
  const char* name;
  double mass;  // kg; 0: does not move.
  Vector I;     // Principal moments of inertia about the centre, along its axes. kg m^2
  Matrix R;     // Orientation at the start.
  Vector p, v, w;  // Centre, velocity and spin at the start. World frame.
  double restitution, friction;
  Vector force;   // Constant, through the centre. N
  bool collides;  // false: passes through everything.
};

struct State {
  Vector p;
  Matrix R;
  Vector v, w;
};
using WorldState = std::vector<State>;

const Body kBodies[] = {
{bodies}};
constexpr int kCount = {count};
constexpr double kStep = {step};  // s
constexpr Vector kGravity = {gravity};

// The rotation by a quaternion.
Matrix Rotation(double w, double x, double y, double z) {
  const double s = 1 / std::sqrt(w * w + x * x + y * y + z * z);
  w *= s, x *= s, y *= s, z *= s;
  return {1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
          2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
          2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)};
}
)";

constexpr const char* kSimulate = R"({set_up}
  std::map<int, WorldState> states;
  for (int step = 0; step <= *wanted.rbegin(); ++step) {
    if (step > 0) {
{step}    }
    if (wanted.count(step) == 0) continue;
    WorldState& state = states[step];
    for (int i = 0; i < kCount; ++i) {
      state.push_back({kBodies[i].p, kBodies[i].R, {}, {}});
      if (kBodies[i].mass == 0) continue;
{read}    }
  }
{clean_up}  return states;
)";

std::string BodyText(const RigidBody& body) {
  const Eigen::Vector3d I =
      body.mass > 0 ? InertiaOf(body) : Eigen::Vector3d(Eigen::Vector3d::Zero());
  return fmt::format(
      "    // {}\n    {{{}, {}, {{{}}},\n     {{{}}},\n     {{{}}},\n     {{{}}},\n"
      "     {{{}}},\n     {}, {}, {{{}}}, {}}},\n",
      Describe(body.placed), Quoted(body.name), Literal(body.mass), Literals(I),
      Literals(body.placed.X_WB.R_WB), Literals(body.placed.X_WB.p_WB),
      Literals(body.v_WB), Literals(body.w_WB), Literal(body.restitution),
      Literal(body.friction), Literals(body.force_W), body.collides ? "true" : "false");
}

/** Replaces `{name}` in `text`, in which other braces are those of the program. */
void Put(std::string_view name, const std::string& value, std::string& text) {
  const std::string field = fmt::format("{{{}}}", name);
  text.replace(text.find(field), field.size(), value);
}

const WorldParameter& ParameterNamed(const OracleInfo& oracle, std::string_view name) {
  return *std::ranges::find(oracle.parameters, name, &WorldParameter::name);
}

void Refuse(bool has, std::string_view what) {
  if (!has) return;
  throw CannotReproduce(fmt::format(
      "the world has {}; expected rigid bodies alone: programs for particles, springs, "
      "distance joints, cloths and pushes are not supported",
      what));
}

}  // namespace

EngineCode WorldCodeOf(const World& world, const OracleInfo& oracle) {
  if (oracle.external) {
    throw CannotReproduce(fmt::format(
        "{} is a program of its own, and what it calls is not known", oracle.name));
  }
  Refuse(!world.particles.empty(), "particles");
  Refuse(!world.springs.empty(), "springs");
  Refuse(!world.joints.empty(), "distance joints");
  Refuse(!world.cloths.empty(), "cloths");
  Refuse(!world.pushes.empty(), "pushes");
  if (oracle.external)
    throw CannotReproduce(fmt::format(
        "{} is a program of its own; expected an oracle of this build", oracle.name));
  if (oracle.library == "ODE") return OdeWorldCode(world, oracle);
  if (oracle.library == "Bullet") return BulletWorldCode(world, oracle);
  if (oracle.library == "MuJoCo") return MujocoWorldCode(world, oracle);
  if (oracle.library == "DART") return DartWorldCode(world, oracle);
  throw CannotReproduce(
      fmt::format("programs for worlds of {} are not supported; expected an oracle of "
                  "ODE, Bullet, MuJoCo or DART",
                  oracle.name));
}

std::string BodiesText(const World& world) {
  std::string bodies;
  for (const RigidBody& body : world.bodies) bodies += BodyText(body);
  std::string text = kTypes;
  Put("count", std::to_string(world.bodies.size()), text);
  Put("step", Literal(world.dt), text);
  Put("gravity", fmt::format("{{{}}}", Literals(world.gravity_W)), text);
  Put("bodies", bodies, text);  // Last: names may contain any text.
  return text;
}

std::string SimulateText(const SimulationText& text) {
  std::string simulate = kSimulate;
  Put("set_up", text.set_up, simulate);
  Put("step", text.step, simulate);
  Put("read", text.read, simulate);
  Put("clean_up", text.clean_up, simulate);
  return simulate;
}

double ValueOf(const OracleInfo& oracle, std::string_view name) {
  const WorldParameter& parameter = ParameterNamed(oracle, name);
  return ValuesOf({&parameter, 1}, oracle.setup).front();
}

std::string IfChanged(const OracleInfo& oracle, std::string_view name,
                      std::string_view statement) {
  const bool changed = ValueOf(oracle, name) != ParameterNamed(oracle, name).shipped;
  return changed ? Explained(oracle, name, statement) : "";
}

std::string Explained(const OracleInfo& oracle, std::string_view name,
                      std::string_view statement) {
  const WorldParameter& parameter = ParameterNamed(oracle, name);
  const bool changed = ValueOf(oracle, name) != parameter.shipped;
  std::string comment(parameter.what);
  comment.front() = static_cast<char>(std::toupper(comment.front()));
  comment += fmt::format(". Default: {}.", parameter.shipped);
  if (changed && !parameter.why.empty()) comment += " " + parameter.why;
  return fmt::format("{}  {}\n", Commented(comment, "  // "), statement);
}

}  // namespace touchstone
