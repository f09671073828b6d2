#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace touchstone {

/** Returns the lines of a report.jsonl. Throws nlohmann::json::exception. */
std::vector<nlohmann::json> LinesOf(const std::string& text);

/** Returns the lines of one kind, in their order. */
std::vector<nlohmann::json> LinesOf(const std::string& text, const std::string& kind);

}  // namespace touchstone
