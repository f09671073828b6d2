#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/engine_code.h"
#include "reports/reproduce/mujoco_text.h"

namespace touchstone {
namespace {

struct Geom {
  std::string type;
  Eigen::Vector3d size;
};

Geom GeomOf(const Shape& shape) {
  if (const auto* s = std::get_if<Sphere>(&shape))
    return {"mjGEOM_SPHERE", {s->radius, 0, 0}};
  if (const auto* s = std::get_if<Box>(&shape)) return {"mjGEOM_BOX", s->half_extents};
  if (const auto* s = std::get_if<Capsule>(&shape))
    return {"mjGEOM_CAPSULE", {s->radius, s->half_length, 0}};
  if (const auto* s = std::get_if<Cylinder>(&shape))
    return {"mjGEOM_CYLINDER", {s->radius, s->half_length, 0}};
  if (std::holds_alternative<HalfSpace>(shape)) return {"mjGEOM_PLANE", {0, 0, 1}};
  throw CannotReproduce("MuJoCo has no such shape");
}

std::string BodyText(const Body& body) {
  const Geom geom = GeomOf(body.shape);
  return fmt::format("    {{{}, {{{}}}, {{{}}},\n     {{{}}}}},\n", geom.type,
                     Literals(geom.size), Literals(body.X_WB.p_WB),
                     Literals(body.X_WB.R_WB));
}

constexpr const char* kDefinitions = R"(struct Geom {{
  int type;
  mjtNum size[3], xpos[3], xmat[9];
}};
const Geom kGeoms[2] = {{
{}}};

const char* const kModel =
    "<mujoco><worldbody><geom type=\"sphere\" size=\"1\"/>"
    "<geom type=\"sphere\" size=\"1\"/></worldbody></mujoco>";
)";

constexpr const char* kAsk = R"(  mjModel* const model = Load(kModel);
  mjData* const data = mj_makeData(model);
  for (int i = 0; i < 2; ++i) {
    model->geom_type[i] = kGeoms[i].type;
    mju_copy(model->geom_size + 3 * i, kGeoms[i].size, 3);
    mju_copy(data->geom_xpos + 3 * i, kGeoms[i].xpos, 3);
    mju_copy(data->geom_xmat + 9 * i, kGeoms[i].xmat, 9);
  }
  // MuJoCo takes the geom of the lesser type first.
  const bool swapped = kGeoms[0].type > kGeoms[1].type;
  const int first = swapped ? 1 : 0;
  mjContact contacts[mjMAXCONPAIR];
  const int count = mjCOLLISIONFUNC[kGeoms[first].type][kGeoms[1 - first].type](
      model, data, contacts, first, 1 - first, 0);
  std::printf("mjCOLLISIONFUNC: %d contacts\n", count);
  Answer answer;
  answer.touching = count > 0;
  for (int i = 0; i < count; ++i) {
    const mjContact& c = contacts[i];
    std::printf("contact %d: dist %.17g, normal (%.17g, %.17g, %.17g), "
                "pos (%.17g, %.17g, %.17g)\n", i, c.dist, c.frame[0], c.frame[1],
                c.frame[2], c.pos[0], c.pos[1], c.pos[2]);
    const double sign = swapped ? -1 : 1;
    const Vector n = {sign * c.frame[0], sign * c.frame[1], sign * c.frame[2]};
    answer.contacts.push_back({{c.pos[0], c.pos[1], c.pos[2]}, c.dist, n});
    if (i > 0 && !(c.dist < answer.separation)) continue;
    answer.separation = c.dist;
    answer.n = n;
  }
  return answer;
)";

}  // namespace

EngineCode MujocoCode(const ContactQuery& query, const std::string&) {
  EngineCode code;
  code.includes = MujocoIncludes();
  code.definitions = fmt::format(kDefinitions, BodyText(query.A) + BodyText(query.B)) +
                     LoadMujocoModel();
  code.ask = kAsk;
  code.find = FindMujoco();
  code.call = "the pair's function of mjCOLLISIONFUNC with margin 0";
  code.package = "libmujoco-dev";
  return code;
}

}  // namespace touchstone
