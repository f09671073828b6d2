#pragma once

#include "scenarios/toml/file_log.h"
#include "scenarios/toml/parser.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

// Each function returns the contents of a table. Where CheckStructure() reports an error,
// a harmless default is used. The caller sets the names. `log` gets the notes.

RigidBody RigidBodyFrom(const toml::table& table, FileLog& log);
Particle ParticleFrom(const toml::table& table, FileLog& log);
Cloth ClothFrom(const toml::table& table, FileLog& log);

}  // namespace touchstone
