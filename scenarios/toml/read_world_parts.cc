#include "scenarios/toml/read_world_parts.h"

#include "scenarios/toml/read_body.h"
#include "scenarios/toml/values.h"

namespace touchstone {
namespace {

ClothSprings ClothSpringsFrom(const toml::node* node) {
  const toml::table* table = node ? node->as_table() : nullptr;
  if (!table) return {};
  return {NumberFrom(table->get("stiffness"), 0), NumberFrom(table->get("damping"), 0)};
}

std::vector<std::pair<int, int>> NodesFrom(const toml::node* node) {
  std::vector<std::pair<int, int>> nodes;
  const toml::array* array = node ? node->as_array() : nullptr;
  if (!array) return nodes;
  for (const toml::node& element : *array) {
    const toml::array* pair = element.as_array();
    // All or none: faults refer to nodes by their index in the file.
    if (!pair || pair->size() != 2) return {};
    nodes.emplace_back(IntegerFrom(pair->get(0), 0), IntegerFrom(pair->get(1), 0));
  }
  return nodes;
}

}  // namespace

RigidBody RigidBodyFrom(const toml::table& table, FileLog& log) {
  RigidBody body;
  body.placed = BodyFrom(table, log);
  body.mass = NumberFrom(table.get("mass"), body.mass);
  if (AreNumbers(table.get("inertia"), 3)) {
    body.inertia = VectorFrom(table.get("inertia"), Eigen::Vector3d::Ones());
  }
  body.v_WB = VectorFrom(table.get("velocity"), body.v_WB);
  body.w_WB = VectorFrom(table.get("spin"), body.w_WB);
  body.restitution = NumberFrom(table.get("restitution"), body.restitution);
  body.friction = NumberFrom(table.get("friction"), body.friction);
  body.force_W = VectorFrom(table.get("force"), body.force_W);
  body.collides = table["collides"].value_or(body.collides);
  return body;
}

Particle ParticleFrom(const toml::table& table, FileLog&) {
  Particle particle;
  particle.p_W = VectorFrom(table.get("position"), particle.p_W);
  particle.v_W = VectorFrom(table.get("velocity"), particle.v_W);
  particle.mass = NumberFrom(table.get("mass"), particle.mass);
  particle.damping = NumberFrom(table.get("damping"), particle.damping);
  particle.bounce = NumberFrom(table.get("bounce"), particle.bounce);
  return particle;
}

Cloth ClothFrom(const toml::table& table, FileLog&) {
  Cloth cloth;
  cloth.n = IntegerFrom(table.get("n"), cloth.n);
  cloth.spacing = NumberFrom(table.get("spacing"), cloth.spacing);
  cloth.centre = VectorFrom(table.get("centre"), cloth.centre);
  cloth.node_mass = NumberFrom(table.get("node_mass"), cloth.node_mass);
  cloth.damping = NumberFrom(table.get("damping"), cloth.damping);
  cloth.bounce = NumberFrom(table.get("bounce"), cloth.bounce);
  cloth.structural = ClothSpringsFrom(table.get("structural"));
  cloth.shear = ClothSpringsFrom(table.get("shear"));
  cloth.bend = ClothSpringsFrom(table.get("bend"));
  cloth.pinned = NodesFrom(table.get("pinned"));
  return cloth;
}

}  // namespace touchstone
