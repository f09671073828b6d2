#pragma once

#include <span>
#include <string_view>

namespace touchstone {

/** Returns the name that `misspelt` most likely means: the one at the smallest edit
 distance (letters inserted, deleted, replaced, or two neighbours swapped), the first of
 equals; empty where all of them differ in more than a third of their letters, since that
 is no misspelling. */
std::string_view NearestName(std::string_view misspelt,
                             std::span<const std::string_view> names);

}  // namespace touchstone
