#pragma once

#include "scenarios/toml/parser.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

// Each returns what a table says, harmless values where CheckStructure() has something to
// say. Names are left for the caller.

RigidBody RigidBodyFrom(const toml::table& table);
Particle ParticleFrom(const toml::table& table);
Cloth ClothFrom(const toml::table& table);

}  // namespace touchstone
