#include "scenarios/diagnostic.h"

#include <fmt/format.h>

namespace touchstone {
namespace {

std::string PlaceOf(const Diagnostic& diagnostic) {
  if (diagnostic.line == 0) return diagnostic.file;
  return fmt::format("{}:{}:{}", diagnostic.file, diagnostic.line, diagnostic.column);
}

}  // namespace

std::string ToString(const Diagnostic& diagnostic) {
  return fmt::format("{}: {}; expected {}", PlaceOf(diagnostic), diagnostic.what,
                     diagnostic.expected);
}

std::string ToNote(const Diagnostic& note) {
  return fmt::format("{}: note: {}", PlaceOf(note), note.what);
}

}  // namespace touchstone
