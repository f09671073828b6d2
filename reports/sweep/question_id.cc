#include "reports/sweep/question_id.h"

#include <charconv>
#include <vector>

#include <fmt/format.h>

namespace touchstone {
namespace {

std::vector<std::string_view> PartsOf(std::string_view id) {
  std::vector<std::string_view> parts;
  for (std::size_t at = 0; (at = id.find('/')) != std::string_view::npos;
       id.remove_prefix(at + 1))
    parts.push_back(id.substr(0, at));
  parts.push_back(id);
  return parts;
}

std::optional<std::uint64_t> NumberOf(std::string_view digits) {
  std::uint64_t number = 0;
  const char* const end = digits.data() + digits.size();
  const auto [last, error] = std::from_chars(digits.data(), end, number);
  if (error != std::errc() || last != end) return std::nullopt;
  return number;
}

/** Names of kinds have underscores, so the name of a pair is compared as a whole. */
std::optional<std::pair<ShapeKind, ShapeKind>> PairNamed(std::string_view name) {
  for (int a = 0; a < kShapeKinds; ++a) {
    for (int b = 0; b < kShapeKinds; ++b) {
      const std::pair pair(static_cast<ShapeKind>(a), static_cast<ShapeKind>(b));
      if (pair == std::pair(ShapeKind::kHalfSpace, ShapeKind::kHalfSpace)) continue;
      if (name == fmt::format("{}_{}", NameOf(pair.first), NameOf(pair.second)))
        return pair;
    }
  }
  return std::nullopt;
}

}  // namespace

std::string IdOf(const Series& series, std::uint64_t index) {
  return std::visit([index](const auto& of_kind) { return IdOf(of_kind, index); },
                    series);
}

std::optional<Series> QuestionOfId(std::string_view id) {
  constexpr std::string_view kSeed = "seed_";
  const std::vector<std::string_view> parts = PartsOf(id);
  if (parts.size() != 5 || parts[0] != "sweep" || !parts[3].starts_with(kSeed))
    return std::nullopt;
  const auto seed = NumberOf(parts[3].substr(kSeed.size()));
  const auto index = NumberOf(parts[4]);
  if (!seed || !index) return std::nullopt;
  if (parts[1] == "world") {
    const auto family = WorldFamilyNamed(parts[2]);
    if (!family) return std::nullopt;
    return WorldSeries{.family = *family, .seed = *seed, .first = *index, .count = 1};
  }
  const auto family = FamilyNamed(parts[1]);
  const auto pair = PairNamed(parts[2]);
  if (!family || !pair) return std::nullopt;
  return QuestionSeries{.family = *family,
                        .A = pair->first,
                        .B = pair->second,
                        .seed = *seed,
                        .first = *index,
                        .count = 1};
}

}  // namespace touchstone
