#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace touchstone {

/** Returns "1 scenario" or "2 scenarios". `plural` is for nouns that do not just take an
 s. */
std::string Counted(std::uint64_t count, std::string_view noun,
                    std::string_view plural = "");
/** As above, of a count ≥ 0. */
std::string Counted(int count, std::string_view noun, std::string_view plural = "");

}  // namespace touchstone
