#include "scenarios/diagnostic.h"

#include <fmt/format.h>

namespace touchstone {

std::string ToString(const Diagnostic& diagnostic) {
  return fmt::format("{}:{}:{}: {}; expected {}", diagnostic.file, diagnostic.line,
                     diagnostic.column, diagnostic.what, diagnostic.expected);
}

}  // namespace touchstone
