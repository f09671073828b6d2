#include "scenarios/diagnostic.h"

#include <fmt/format.h>

namespace touchstone {

std::string ToString(const Diagnostic& diagnostic) {
  const std::string place =
      diagnostic.line > 0 ? fmt::format(":{}:{}", diagnostic.line, diagnostic.column)
                          : "";
  return fmt::format("{}{}: {}; expected {}", diagnostic.file, place, diagnostic.what,
                     diagnostic.expected);
}

}  // namespace touchstone
