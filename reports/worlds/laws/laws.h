#pragma once

#include <span>
#include <string_view>

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Returns every law, sorted by name. */
std::span<const Law> Laws();

/** Returns the law of that name, or of that older name; or null. */
const Law* FindLaw(std::string_view name);

}  // namespace touchstone
