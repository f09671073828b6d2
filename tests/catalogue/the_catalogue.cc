#include "tests/catalogue/the_catalogue.h"

#include <algorithm>

#include "tests/source_tree.h"

namespace touchstone {

const Catalogue& TheCatalogue() {
  static const Catalogue catalogue = ReadCatalogue(InSourceTree("scenarios/catalogue"));
  return catalogue;
}

std::map<std::string, const Scenario*> Below(std::string_view folder) {
  std::map<std::string, const Scenario*> below;
  for (const Scenario& scenario : TheCatalogue().scenarios) {
    if (scenario.id.starts_with(folder)) below.emplace(scenario.id, &scenario);
  }
  return below;
}

std::map<std::string, std::vector<const Scenario*>> ByPairFolder() {
  std::map<std::string, std::vector<const Scenario*>> pairs;
  for (int a = 0; a < kShapeKinds; ++a) {
    for (int b = a; b < kShapeKinds; ++b) {
      const auto kind_a = static_cast<ShapeKind>(a);
      const auto kind_b = static_cast<ShapeKind>(b);
      if (kind_a == ShapeKind::kHalfSpace)
        continue;  // Two half-spaces are not a valid query.
      const std::string pair = PairFolder(kind_a, kind_b);
      for (const auto& [id, scenario] : Below("contact/" + pair + "/")) {
        pairs[pair].push_back(scenario);
      }
      pairs.try_emplace(pair);
    }
  }
  return pairs;
}

std::string PairFolder(ShapeKind a, ShapeKind b) {
  return std::string(NameOf(std::min(a, b))) + "_" + std::string(NameOf(std::max(a, b)));
}

}  // namespace touchstone
