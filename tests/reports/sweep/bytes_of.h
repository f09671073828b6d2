#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace touchstone {

/** Returns the bytes of `file`; none if it cannot be read. */
inline std::string BytesOf(const std::filesystem::path& file) {
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

}  // namespace touchstone
