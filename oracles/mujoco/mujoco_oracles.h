#pragma once

#include <memory>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** Returns the oracles "mujoco" and "mujoco/rk4". Both simulate worlds (mujoco_world.h),
 the first with MuJoCo's semi-implicit Euler, the second with the fourth-order Runge-Kutta
 method. The first also answers contact queries with MuJoCo's collision functions
 (mujoco_contacts.h). */
std::vector<std::unique_ptr<Oracle>> MujocoOracles();

}  // namespace touchstone
