#pragma once

#include <memory>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** Returns "mujoco" and "mujoco/rk4". Both simulate worlds, the first by MuJoCo's
 semi-implicit Euler, the second by Runge and Kutta's method of fourth order
 (mujoco_world.h). The first answers contact queries, by MuJoCo's collision functions
 (mujoco_contacts.h). */
std::vector<std::unique_ptr<Oracle>> MujocoOracles();

}  // namespace touchstone
