#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
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

/** Accepts a duration such as "90s", "10m", "2h" or "1d": a whole number and a unit. */
Expected Duration();

/** Returns the duration that Duration() accepts. */
std::chrono::seconds DurationOf(const std::string& text);

/** Accepts a part of a whole, "K/N" with 1 <= K <= N. */
Expected PartOfWhole();

/** Returns K and N of what PartOfWhole() accepts. */
std::pair<std::uint64_t, std::uint64_t> PartOf(const std::string& text);

/** Accepts one of `names`. The error lists them and suggests the nearest. */
Expected OneOf(const std::vector<std::string>& names);

}  // namespace touchstone
