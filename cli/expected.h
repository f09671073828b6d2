#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace touchstone {

/** Returns what is wrong with the text that follows an option; empty where nothing is. */
using Expected = std::function<std::string(const std::string& text)>;

/** Accepts whole numbers in [least, most]; says which are expected for anything else. */
Expected WholeNumber(std::uint64_t least = 0,
                     std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/** Accepts 1 to the number of processors that this machine has. */
Expected NumberOfThreads();

/** Accepts one of `names`; says which are expected, and the nearest, for anything else.
 */
Expected OneOf(const std::vector<std::string>& names);

}  // namespace touchstone
