#pragma once

#include <span>
#include <string>
#include <string_view>

namespace touchstone {

/** Returns " (did you mean right?)" with the name that `misspelt` most likely stands for;
 empty if no name is near (scenarios/schema/nearest_name.h). */
std::string DidYouMean(std::string_view misspelt,
                       std::span<const std::string_view> names);

}  // namespace touchstone
