#pragma once

#include "oracles/bullet/bullet_module.h"
#include "oracles/bullet/bullet_oracles.h"

namespace touchstone {

/** Returns who the oracle of this precision and path is, what it can do and what its
 adapter sets and converts. Version and unit roundoff are those that `module` reports. */
OracleInfo BulletOracleInfo(BulletPrecision precision, BulletPath path,
                            const BulletModule& module);

}  // namespace touchstone
