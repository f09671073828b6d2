#include "json_lines.h"

#include <sstream>

namespace touchstone {

std::vector<nlohmann::json> LinesOf(const std::string& text) {
  std::istringstream in(text);
  std::vector<nlohmann::json> lines;
  for (std::string line; std::getline(in, line);)
    lines.push_back(nlohmann::json::parse(line));
  return lines;
}

std::vector<nlohmann::json> LinesOf(const std::string& text, const std::string& kind) {
  std::vector<nlohmann::json> lines;
  for (nlohmann::json& line : LinesOf(text)) {
    if (line["kind"] == kind) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace touchstone
