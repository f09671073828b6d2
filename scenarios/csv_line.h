#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace touchstone {

// Lines of CSV files that hold numbers and words: RFC 4180 without quotation marks.

/** Returns the cells of a line, as views of it. A carriage return at the end of the line
 belongs to no cell. */
std::vector<std::string_view> CellsOf(std::string_view line);

/** Returns the finite decimal number that fills the whole cell. */
std::optional<double> FiniteNumberIn(std::string_view cell);

}  // namespace touchstone
