#pragma once

#include "oracles/bullet/bullet_module.h"
#include "oracles/bullet/bullet_oracles.h"

namespace touchstone {

/** Returns the description of the oracle of this precision and path: its name, its
 capabilities, and the values that its adapter sets and converts. Version and unit
 roundoff are those that `module` reports. */
OracleInfo BulletOracleInfo(BulletPrecision precision, BulletPath path,
                            const BulletModule& module);

}  // namespace touchstone
