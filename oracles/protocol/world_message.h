#pragma once

#include <span>

#include "oracles/protocol/message.h"
#include "oracles/world_setup.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns `world` as the object "world" of a message. Its keys are those of a scenario
 file, but nothing is left to a default: every moving body has its moments of inertia, and
 what a file names is an index here. */
Json ToJson(const World& world);

/** Returns the world in `json`.
 @throws ProtocolError if it is not a valid world. */
World WorldFrom(const Received& json);

/** Returns the values of `parameters` in force with `setup`, by name. */
Json ParametersJson(std::span<const WorldParameter> parameters, const WorldSetup& setup);

/** Returns the setup with the values in `json`, where any may be absent.
 @throws ProtocolError for a name that is not a parameter, or a value out of its range. */
WorldSetup SetupFrom(const Received& json, std::span<const WorldParameter> parameters);

}  // namespace touchstone
