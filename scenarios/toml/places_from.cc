#include "scenarios/toml/places_from.h"

#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace touchstone {
namespace {

FilePlaces::Place PlaceOf(const toml::source_region& at) {
  return {static_cast<int>(at.begin.line), static_cast<int>(at.begin.column)};
}

/** Adds the positions of everything below `node`, whose path is `path`. */
void AddBelow(const toml::node& node, const std::string& path, FilePlaces& places) {
  const auto add = [&](const std::string& child, const toml::source_region& key,
                       const toml::node& value) {
    places.by_path[child] = {PlaceOf(key), PlaceOf(value.source())};
    AddBelow(value, child, places);
  };
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, value] : *table)
      add(fmt::format("{}.{}", path, key.str()), key.source(), value);
  } else if (const toml::array* array = node.as_array()) {
    for (std::size_t i = 0; i < array->size(); ++i) {
      const toml::node& element = *array->get(i);
      add(fmt::format("{}[{}]", path, i), element.source(), element);
    }
  }
}

}  // namespace

FilePlaces PlacesFrom(const toml::table& file, std::string_view file_name) {
  constexpr std::array kKept = {"expect", "claims", "indicts"};
  FilePlaces places;
  places.file = file_name;
  for (const char* name : kKept) {
    const auto found = file.find(name);
    if (found == file.end()) continue;
    places.by_path[name] = {PlaceOf(found->first.source()),
                            PlaceOf(found->second.source())};
    AddBelow(found->second, name, places);
  }
  return places;
}

}  // namespace touchstone
