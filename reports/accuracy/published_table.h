#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone {

/** The cells of one line of a Markdown table, without the spaces around them. */
using TableLine = std::vector<std::string_view>;

/** Returns the lines of `text` that begin and end with a bar, including the headers and
 rules of tables. The cells are views into `text`. */
std::vector<TableLine> TableLines(std::string_view text);

/** Returns the published form of the largest measured error: kProposedBound times the
 error, rounded up to two digits; `absent` where nothing was measured. */
std::string PublishedCell(const std::optional<double>& worst, std::string_view absent);

/** Returns the fault of a published cell, or "": an error above it, an error below
 kImproved of it (improved: a later regression would go unseen), a number where nothing
 was measured, or no number where there is an error. */
std::string FaultOfCell(std::string_view cell, const std::optional<double>& worst,
                        std::string_view absent);

}  // namespace touchstone
