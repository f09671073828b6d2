#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include <mujoco/mujoco.h>

#include "scenarios/worlds/world.h"

namespace touchstone {

struct DeleteMujoco {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};

using MujocoModel = std::unique_ptr<mjModel, DeleteMujoco>;
using MujocoData = std::unique_ptr<mjData, DeleteMujoco>;

/** Makes MuJoCo print to the standard error instead of a file in the working directory,
 abort instead of exit, and use large pages for its memory. Affects the whole process;
 only the first call has an effect. Thread safe. */
void InitialiseMujoco();

/** Returns the model compiled from `mjcf`, MuJoCo's own text format. Thread safe.
 @throws std::runtime_error with MuJoCo's message if it refuses the model. */
MujocoModel Compile(const std::string& mjcf);

/** Returns `world` as MJCF: a body "b<i>" with a geom "g<i>" for each moving body, and a
 geom "g<i>" of MuJoCo's world for each static one. A spring is a tendon "s<i>"; a joint
 is a tendon "j<i>" with an equality of the same name. Springs and joints that cannot move
 anything are left out. The model can hold `contacts` contacts, or fewer if the world
 cannot have that many: MuJoCo clears memory that grows with their square. Options keep
 their default values.
 @pre No shape is a cone, hulls have volume and half-spaces are static; no anchor is on a
 particle.
 @throws std::runtime_error if MuJoCo cannot hold that many contacts. */
std::string ToMjcf(const World& world, std::size_t contacts);

}  // namespace touchstone
