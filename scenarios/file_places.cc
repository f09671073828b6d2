#include "scenarios/file_places.h"

#include <utility>

namespace touchstone {
namespace {

/** Returns the path of the parent: "claims[0].numbers" for "claims[0].numbers.slack",
 "claims" for "claims[0]". */
std::string_view Around(std::string_view path) {
  const std::size_t end = path.find_last_of(".[");
  return path.substr(0, end == std::string_view::npos ? 0 : end);
}

FilePlaces::KeyAndValue PlacesOf(const FilePlaces& places, std::string_view path) {
  for (; !path.empty(); path = Around(path)) {
    const auto found = places.by_path.find(path);
    if (found != places.by_path.end()) return found->second;
  }
  return {};
}

}  // namespace

Diagnostic ErrorAtValue(const FilePlaces& places, std::string_view path, std::string what,
                        std::string expected) {
  const FilePlaces::Place place = PlacesOf(places, path).value;
  return {places.file, place.line, place.column, std::move(what), std::move(expected)};
}

Diagnostic ErrorAtKey(const FilePlaces& places, std::string_view path, std::string what,
                      std::string expected) {
  const FilePlaces::Place place = PlacesOf(places, path).key;
  return {places.file, place.line, place.column, std::move(what), std::move(expected)};
}

}  // namespace touchstone
