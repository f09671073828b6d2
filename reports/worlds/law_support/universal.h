#pragma once

#include <optional>

#include "reports/worlds/law_support/law.h"

namespace touchstone {

// The claims by which a law judges every motion; see Law::universal.

/** Returns the claim of `law` about everything that moves in `world`; empty if the law
 does not apply to that. */
std::optional<Claim> ClaimAboutAll(const Law& law, const World& world);

/** Returns the claim of `law` that names everything in `world` to which the law applies
 by itself; empty if there is nothing. */
std::optional<Claim> ClaimAboutEach(const Law& law, const World& world);

/** Returns whether nothing that moves in `world` can touch anything fixed, or a particle
 or cloth touch anything. The claim of an isolated system then needs no author who vouches
 that it stays isolated. */
bool TouchesNothingFixed(const World& world);

}  // namespace touchstone
