#pragma once

#include <memory>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** The precision of one of Bullet's two builds. */
enum class BulletPrecision { kDouble, kFloat };

/** Returns Bullet's oracles of one precision: the world's dispatch path ("bullet",
 "bullet_float") and the closest-point path ("bullet/gjk", "bullet_float/gjk").

 The two builds export the same symbols, so each is linked into a separate module, which
 is opened here and never closed. The module is searched for in the folders of
 TOUCHSTONE_PLUGIN_PATH, then along the run path of the program.

 @throws std::runtime_error with the folders searched if there is no such module, or if it
 was built from another version of Touchstone. */
std::vector<std::unique_ptr<Oracle>> BulletOracles(BulletPrecision precision);

}  // namespace touchstone
