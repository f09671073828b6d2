#pragma once

#include "scenarios/toml/parser.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

// Each function returns the contents of a table. Where CheckStructure() reports an error,
// a harmless default is used. The caller sets the names.

RigidBody RigidBodyFrom(const toml::table& table);
Particle ParticleFrom(const toml::table& table);
Cloth ClothFrom(const toml::table& table);

}  // namespace touchstone
