#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace touchstone {

/** A check of an option's value. Returns the error in `text`; empty if it is valid. */
using Expected = std::function<std::string(const std::string& text)>;

/** Accepts whole numbers in [least, most]. The error states the accepted range. */
Expected WholeNumber(std::uint64_t least = 0,
                     std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/** Accepts whole numbers from 1 to the number of processors of this machine. */
Expected NumberOfThreads();

/** Accepts finite numbers >= 0. */
Expected NotNegative();

/** Accepts one of `names`. The error lists them and suggests the nearest. */
Expected OneOf(const std::vector<std::string>& names);

}  // namespace touchstone
