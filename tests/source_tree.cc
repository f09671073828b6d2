#include "tests/source_tree.h"

namespace touchstone {

std::filesystem::path InSourceTree(std::string_view path) {
  return std::filesystem::path(TOUCHSTONE_SOURCE_DIR) / path;
}

}  // namespace touchstone
