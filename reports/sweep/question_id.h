#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "reports/sweep/series.h"

namespace touchstone {

/** Returns the id of question `index` of a series, such as "sweep/random/box_box/seed_1/"
 and the index with twenty digits. */
std::string IdOf(const Series& series, std::uint64_t index);

/** Returns the question of that id, as a series of one. The index may have fewer digits.
 Empty for any other text, and for a question of a worst-case search, which depends on the
 oracle that was searched. */
std::optional<Series> QuestionOfId(std::string_view id);

}  // namespace touchstone
