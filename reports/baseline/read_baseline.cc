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

constexpr const char* kExpected = "a report.jsonl of `touchstone run --out DIR`";

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
bool AddFinding(const Json& json, Baseline& baseline) {
  const std::optional<MeasureKind> measure = MeasureNamed(TextOf(json, "measure"));
  const std::optional<Verdict> verdict = VerdictNamed(TextOf(json, "verdict"));
  const auto value = json.find("value");
  if (!measure || !verdict || value == json.end() || !IsNumber(*value)) return false;
  baseline.Add(
      {TextOf(json, "scenario"), TextOf(json, "oracle"), *measure, TextOf(json, "law")},
      {.value = NumberOf(*value), .verdict = *verdict});
  return true;
}

Diagnostic At(const std::filesystem::path& file, int line, int column, std::string what) {
  return {file.string(), line, column, std::move(what), kExpected};
}

}  // namespace

void Baseline::Add(const LedgerCell& cell, const Measured& measured) {
  Measured& worst = cells.try_emplace(cell, measured).first->second;
  if (std::isnan(measured.value) || measured.value > worst.value)
    worst.value = measured.value;
  worst.verdict = Worse(worst.verdict, measured.verdict);
  worst.floor = std::fmax(worst.floor, measured.floor);
}

std::optional<Verdict> VerdictNamed(const std::string& name) {
  for (int i = 0; i <= static_cast<int>(Verdict::kInvalid); ++i) {
    const auto verdict = static_cast<Verdict>(i);
    if (NameOf(verdict) == name) return verdict;
  }
  return std::nullopt;
}

BaselineResult ReadBaseline(std::string_view text, const std::filesystem::path& file) {
  const auto refused = [&](int line, int column, std::string what) {
    return BaselineResult{std::nullopt, {At(file, line, column, std::move(what))}};
  };
  Baseline baseline;
  int line = 0;
  for (std::size_t begin = 0; begin < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    Json json;
    try {
      json = Json::parse(text.substr(begin, end - begin));
    } catch (const Json::parse_error& error) {
      return refused(line + 1, std::max(1, static_cast<int>(error.byte)), "is not JSON");
    } catch (const Json::exception&) {
      return refused(line + 1, 1, "has a number that no double holds");
    }
    begin = end + 1;
    if (!json.is_object()) return refused(line + 1, 1, "is no report");
    if (line == 0 && TextOf(json, "format") != "touchstone report")
      return refused(1, 1, "is no report");
    if (line == 0 && json["version"] != 2)
      return refused(1, 1, "is a report of another version");
    if (TextOf(json, "kind") == "finding" && !AddFinding(json, baseline))
      return refused(line + 1, 1, "is no finding that can be read");
  }
  if (line == 0) return refused(1, 1, "is no report");
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
