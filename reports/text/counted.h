#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace touchstone {

/** Returns a count with its noun: "1 scenario" or "2 scenarios". `plural` is for nouns
 whose plural is not formed by adding an s. */
std::string Counted(std::uint64_t count, std::string_view noun,
                    std::string_view plural = "");
/** The same for a signed count, which must be ≥ 0. */
std::string Counted(int count, std::string_view noun, std::string_view plural = "");

}  // namespace touchstone
