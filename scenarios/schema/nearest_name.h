#pragma once

#include <span>
#include <string_view>

namespace touchstone {

/** Returns the name that `misspelt` most likely means: the first name at the smallest
 edit distance (letters inserted, deleted or replaced, or two neighbours swapped). Returns
 an empty view if every name differs in more than a third of its letters, since that is
 not a misspelling. */
std::string_view NearestName(std::string_view misspelt,
                             std::span<const std::string_view> names);

}  // namespace touchstone
