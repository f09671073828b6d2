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

/** Makes MuJoCo speak to the standard error instead of a file in the working directory,
 and abort where it would exit. For the whole process, once. */
void InitialiseMujoco();

/** Returns what MuJoCo makes of `mjcf`, a model in its own format.
 @throws std::runtime_error with what it says where it refuses. Thread safe. */
MujocoModel Compile(const std::string& mjcf);

/** Returns `world` as MJCF: a body "b<i>" with a geom "g<i>" for each body, the static
 ones as geoms of MuJoCo's world; a tendon "s<i>" for each spring and "j<i>" for each
 joint, with an equality of the same name. No entry for what has nothing to move. There is
 room for so many `contacts`, or for all that there can be, if those are fewer: MuJoCo
 clears memory that grows with their square. Options are left as they are by default.
 @pre Shapes are spheres, boxes and static half-spaces; anchors are on no particle.
 @throws std::runtime_error where MuJoCo has no such room. */
std::string ToMjcf(const World& world, std::size_t contacts);

}  // namespace touchstone
