#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone {

/** The cells of one line of a Markdown table, without the spaces around them. */
using TableLine = std::vector<std::string_view>;

/** Returns the lines of `text` that begin and end with a bar: the headers and rules of
 tables, too. They view into `text`. */
std::vector<TableLine> TableLines(std::string_view text);

/** Returns how the largest error that was measured is published: kProposedBound times it,
 rounded up to two digits; `absent` where nothing was measured. */
std::string PublishedCell(const std::optional<double>& worst, std::string_view absent);

/** Returns what is wrong with a published cell, or nothing: an error above it, an error
 below kImproved of it (improved: a later regression would go unseen), a number where
 there is none, or none where there is one. */
std::string FaultOfCell(std::string_view cell, const std::optional<double>& worst,
                        std::string_view absent);

}  // namespace touchstone
