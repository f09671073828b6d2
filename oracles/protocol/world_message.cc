#include "oracles/protocol/world_message.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "oracles/protocol/query_message.h"
#include "scenarios/worlds/solid.h"
#include "scenarios/worlds/validate_world.h"

namespace touchstone {
namespace {

// The functions of this name below hide those of the headers.
using touchstone::ToJson;

using Eigen::Vector3d;

constexpr int kMostIndex = std::numeric_limits<int>::max();

constexpr std::pair<AnchorKind, std::string_view> kAnchors[] = {
    {AnchorKind::kWorld, "world"},
    {AnchorKind::kBody, "body"},
    {AnchorKind::kParticle, "particle"}};

Json ToJson(const RigidBody& body) {
  Json json;
  json["name"] = body.name;
  json.update(ToJson(body.placed));
  json["mass"] = ToJson(body.mass);
  json["inertia"] = ToJson(InertiaOf(body));
  json["velocity"] = ToJson(body.v_WB);
  json["spin"] = ToJson(body.w_WB);
  json["restitution"] = ToJson(body.restitution);
  json["friction"] = ToJson(body.friction);
  json["force"] = ToJson(body.force_W);
  json["collides"] = body.collides;
  return json;
}

bool HasMoments(const RigidBody& body) {
  return body.mass == 0 || UniformMoments(body.placed.shape, body.mass);
}

RigidBody BodyOfWorldFrom(const Received& json) {
  RigidBody body;
  body.name = json["name"].Text();
  body.placed = BodyFrom(json);
  body.mass = json["mass"].Number();
  const Vector3d inertia = json["inertia"].Vector();
  // The moments of a uniform solid are not stated ones, which few engines can take.
  if (!HasMoments(body) || inertia != InertiaOf(body)) body.inertia = inertia;
  body.v_WB = json["velocity"].Vector();
  body.w_WB = json["spin"].Vector();
  body.restitution = json["restitution"].Number();
  body.friction = json["friction"].Number();
  body.force_W = json["force"].Vector();
  body.collides = json["collides"].Truth();
  return body;
}

Json ToJson(const Particle& particle) {
  return {{"name", particle.name},
          {"position", ToJson(particle.p_W)},
          {"velocity", ToJson(particle.v_W)},
          {"mass", ToJson(particle.mass)},
          {"damping", ToJson(particle.damping)},
          {"bounce", ToJson(particle.bounce)}};
}

Particle ParticleFrom(const Received& json) {
  Particle particle;
  particle.name = json["name"].Text();
  particle.p_W = json["position"].Vector();
  particle.v_W = json["velocity"].Vector();
  particle.mass = json["mass"].Number();
  particle.damping = json["damping"].Number();
  particle.bounce = json["bounce"].Number();
  return particle;
}

Json ToJson(const Anchor& anchor) {
  Json json;
  for (const auto& [kind, name] : kAnchors) {
    if (anchor.on == kind) json["on"] = name;
  }
  if (anchor.on != AnchorKind::kWorld) json["index"] = anchor.index;
  json["point"] = ToJson(anchor.point);
  return json;
}

Anchor AnchorFrom(const Received& json, const World& world) {
  const std::string on = json["on"].Text();
  for (const auto& [kind, name] : kAnchors) {
    if (on != name) continue;
    Anchor anchor;
    anchor.on = kind;
    anchor.point = json["point"].Vector();
    if (kind == AnchorKind::kWorld) return anchor;
    const std::size_t count =
        kind == AnchorKind::kBody ? world.bodies.size() : world.particles.size();
    anchor.index = json["index"].Whole(0, static_cast<int>(count) - 1);
    return anchor;
  }
  json["on"].Fail("\"world\", \"body\" or \"particle\"");
}

Json ToJson(const Spring& spring) {
  return {{"A", ToJson(spring.A)},
          {"B", ToJson(spring.B)},
          {"stiffness", ToJson(spring.stiffness)},
          {"damping", ToJson(spring.damping)},
          {"rest_length", ToJson(spring.rest_length)}};
}

Spring SpringFrom(const Received& json, const World& world) {
  return {AnchorFrom(json["A"], world), AnchorFrom(json["B"], world),
          json["stiffness"].Number(), json["damping"].Number(),
          json["rest_length"].Number()};
}

Json ToJson(const DistanceJoint& joint) {
  return {
      {"A", ToJson(joint.A)}, {"B", ToJson(joint.B)}, {"length", ToJson(joint.length)}};
}

DistanceJoint JointFrom(const Received& json, const World& world) {
  return {AnchorFrom(json["A"], world), AnchorFrom(json["B"], world),
          json["length"].Number()};
}

Json ToJson(const ClothSprings& springs) {
  return {{"stiffness", ToJson(springs.stiffness)}, {"damping", ToJson(springs.damping)}};
}

ClothSprings ClothSpringsFrom(const Received& json) {
  return {json["stiffness"].Number(), json["damping"].Number()};
}

Json ToJson(const Cloth& cloth) {
  Json json = {{"name", cloth.name},
               {"n", cloth.n},
               {"spacing", ToJson(cloth.spacing)},
               {"centre", ToJson(cloth.centre)},
               {"node_mass", ToJson(cloth.node_mass)},
               {"damping", ToJson(cloth.damping)},
               {"bounce", ToJson(cloth.bounce)},
               {"structural", ToJson(cloth.structural)},
               {"shear", ToJson(cloth.shear)},
               {"bend", ToJson(cloth.bend)}};
  Json& pinned = json["pinned"] = Json::array();
  for (const auto& [row, column] : cloth.pinned)
    pinned.push_back(Json::array({row, column}));
  return json;
}

Cloth ClothFrom(const Received& json) {
  Cloth cloth;
  cloth.name = json["name"].Text();
  cloth.n = json["n"].Whole(0, kMostIndex);
  cloth.spacing = json["spacing"].Number();
  cloth.centre = json["centre"].Vector();
  cloth.node_mass = json["node_mass"].Number();
  cloth.damping = json["damping"].Number();
  cloth.bounce = json["bounce"].Number();
  cloth.structural = ClothSpringsFrom(json["structural"]);
  cloth.shear = ClothSpringsFrom(json["shear"]);
  cloth.bend = ClothSpringsFrom(json["bend"]);
  for (const Received& node : json["pinned"].Items()) {
    const std::vector<Received> place = node.Items(2);
    cloth.pinned.emplace_back(place[0].Whole(0, kMostIndex),
                              place[1].Whole(0, kMostIndex));
  }
  return cloth;
}

Json ToJson(const Push& push, double dt) {
  return {{"body", push.body},
          {"after_steps", std::lround(push.time / dt)},
          {"time", ToJson(push.time)},
          {"point", ToJson(push.p_BoP)},
          {"impulse", ToJson(push.J_W)}};
}

Push PushFrom(const Received& json, const World& world) {
  return {json["body"].Whole(0, static_cast<int>(world.bodies.size()) - 1),
          json["time"].Number(), json["point"].Vector(), json["impulse"].Vector()};
}

template <typename Parts, typename... More>
Json ListOf(const Parts& parts, const More&... more) {
  Json list = Json::array();
  for (const auto& part : parts) list.push_back(ToJson(part, more...));
  return list;
}

}  // namespace

Json ToJson(const World& world) {
  Json json;
  json["gravity"] = ToJson(world.gravity_W);
  json["dt"] = ToJson(world.dt);
  json["steps"] = world.steps;
  json["sample_every"] = world.sample_every;
  json["bodies"] = ListOf(world.bodies);
  json["particles"] = ListOf(world.particles);
  json["springs"] = ListOf(world.springs);
  json["joints"] = ListOf(world.joints);
  json["cloths"] = ListOf(world.cloths);
  json["pushes"] = ListOf(world.pushes, world.dt);
  return json;
}

World WorldFrom(const Received& json) {
  World world;
  world.gravity_W = json["gravity"].Vector();
  world.dt = json["dt"].Number();
  world.steps = json["steps"].Whole(1, kMostSteps);
  world.sample_every = json["sample_every"].Whole(1, kMostSteps);
  for (const Received& body : json["bodies"].Items())
    world.bodies.push_back(BodyOfWorldFrom(body));
  for (const Received& particle : json["particles"].Items())
    world.particles.push_back(ParticleFrom(particle));
  for (const Received& spring : json["springs"].Items())
    world.springs.push_back(SpringFrom(spring, world));
  for (const Received& joint : json["joints"].Items())
    world.joints.push_back(JointFrom(joint, world));
  for (const Received& cloth : json["cloths"].Items())
    world.cloths.push_back(ClothFrom(cloth));
  for (const Received& push : json["pushes"].Items())
    world.pushes.push_back(PushFrom(push, world));
  const std::vector<Fault> faults = FaultsOf(world);
  if (faults.empty()) return world;
  const Fault& fault = faults.front();
  throw ProtocolError(
      fmt::format("world.{} {}; expected {}", fault.where, fault.what, fault.expected));
}

Json ParametersJson(std::span<const WorldParameter> parameters, const WorldSetup& setup) {
  const std::vector<double> values = ValuesOf(parameters, setup);
  Json json = Json::object();
  for (std::size_t i = 0; i < parameters.size(); ++i)
    json[parameters[i].name] = ToJson(values[i]);
  return json;
}

WorldSetup SetupFrom(const Received& json, std::span<const WorldParameter> parameters) {
  WorldSetup setup;
  for (const std::string& name : json.Keys()) {
    const auto found = std::ranges::find(parameters, name, &WorldParameter::name);
    if (found == parameters.end()) json[name].Fail("no such key: it is no parameter");
    const double value = json[name].Number();
    const std::string expected = Refusal(*found, value);
    if (!expected.empty()) json[name].Fail(expected);
    setup.chosen[name] = value;
  }
  return setup;
}

}  // namespace touchstone
