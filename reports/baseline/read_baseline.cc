#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/baseline/baseline.h"
#include "reports/finding/severity.h"

namespace touchstone {
namespace {

using Json = nlohmann::json;

constexpr const char* kExpected = "a report.json of `touchstone run --out DIR`";

/** Returns the verdict of that name; empty if there is none. */
std::optional<Verdict> VerdictNamed(const std::string& name) {
  for (int i = 0; i <= static_cast<int>(Verdict::kInvalid); ++i) {
    const auto verdict = static_cast<Verdict>(i);
    if (NameOf(verdict) == name) return verdict;
  }
  return std::nullopt;
}

/** Returns whether `json` is a number as WriteJson() writes it. */
bool IsNumber(const Json& json) {
  return json.is_number() || json == "NaN" || json == "Infinity" || json == "-Infinity";
}

/** Returns a number that WriteJson() has written. */
double NumberOf(const Json& json) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (json.is_number()) return json.get<double>();
  if (json == "NaN") return std::numeric_limits<double>::quiet_NaN();
  return json == "Infinity" ? kInfinity : -kInfinity;
}

std::string TextOf(const Json& finding, const char* key) {
  const auto text = finding.find(key);
  return text != finding.end() && text->is_string() ? text->get<std::string>() : "";
}

/** Adds a finding to a baseline. Returns whether it is one. */
bool Add(const Json& json, Baseline& baseline) {
  if (!json.is_object()) return false;
  const std::optional<MeasureKind> measure = MeasureNamed(TextOf(json, "measure"));
  const std::optional<Verdict> verdict = VerdictNamed(TextOf(json, "verdict"));
  const auto value = json.find("value");
  if (!measure || !verdict || value == json.end() || !IsNumber(*value)) return false;
  const double number = NumberOf(*value);
  const LedgerCell cell{TextOf(json, "scenario"), TextOf(json, "oracle"), *measure,
                        TextOf(json, "law")};
  Baseline::Measured& worst =
      baseline.cells.try_emplace(cell, Baseline::Measured{number, *verdict})
          .first->second;
  if (std::isnan(number) || number > worst.value) worst.value = number;
  worst.verdict = Worse(worst.verdict, *verdict);
  return true;
}

Diagnostic At(const std::filesystem::path& file, int line, int column, std::string what) {
  return {file.string(), line, column, std::move(what), kExpected};
}

}  // namespace

BaselineResult ReadBaseline(std::string_view text, const std::filesystem::path& file) {
  // A report has more to say than its findings, much of it per scenario.
  const auto keep = [](int depth, Json::parse_event_t event, const Json& key) {
    return depth != 1 || event != Json::parse_event_t::key || key == "findings" ||
           key == "format" || key == "version";
  };
  Json json;
  try {
    json = Json::parse(text, keep);
  } catch (const Json::parse_error& error) {
    const std::string_view before = text.substr(0, std::min(error.byte, text.size()));
    const auto line = std::ranges::count(before, '\n');
    const auto column = before.size() - (before.rfind('\n') + 1);
    return {std::nullopt,
            {At(file, static_cast<int>(line) + 1, std::max(1, static_cast<int>(column)),
                "is not JSON")}};
  } catch (const Json::exception&) {
    return {std::nullopt, {At(file, 1, 1, "has a number that no double holds")}};
  }
  if (!json.is_object() || TextOf(json, "format") != "touchstone report" ||
      !json.contains("findings") || !json["findings"].is_array()) {
    return {std::nullopt, {At(file, 1, 1, "is no report")}};
  }
  if (json["version"] != 1) {
    return {std::nullopt, {At(file, 1, 1, "is a report of another version")}};
  }
  Baseline baseline;
  int index = 0;
  for (const Json& finding : json["findings"]) {
    if (!Add(finding, baseline)) {
      return {std::nullopt,
              {At(file, 1, 1, fmt::format("finding {} cannot be read", index))}};
    }
    ++index;
  }
  return {std::move(baseline), {}};
}

BaselineResult ReadBaselineFile(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (!stream || !(text << stream.rdbuf())) {
    return {std::nullopt, {At(file, 1, 1, "cannot be read")}};
  }
  return ReadBaseline(text.str(), file);
}

}  // namespace touchstone
