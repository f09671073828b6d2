#include "cli/did_you_mean.h"

#include <fmt/format.h>

#include "scenarios/schema/nearest_name.h"

namespace touchstone {

std::string DidYouMean(std::string_view misspelt,
                       std::span<const std::string_view> names) {
  const std::string_view nearest = NearestName(misspelt, names);
  return nearest.empty() ? "" : fmt::format(" (did you mean {}?)", nearest);
}

}  // namespace touchstone
