#include "scenarios/validate_scenario.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace touchstone {
namespace {

bool IsOneOf(char c, std::string_view set) {
  return set.find(c) != std::string_view::npos;
}

constexpr std::string_view kLowerAndDigits = "abcdefghijklmnopqrstuvwxyz0123456789_";
constexpr std::string_view kUpper = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";

void CheckText(std::string_view where, std::string_view text,
               std::vector<Fault>& faults) {
  if (!text.empty()) return;
  faults.push_back({std::string(where), "is empty", "a sentence"});
}

void CheckBodyName(std::string_view where, std::string_view name,
                   std::vector<Fault>& faults) {
  if (IsBodyName(name)) return;
  faults.push_back({std::string(where), fmt::format("is \"{}\"", name),
                    "a body name of A-Z, a-z, 0-9, _ and -"});
}

template <class Part>
void AppendPrefixed(std::string_view prefix, const Part& part,
                    std::vector<Fault>& faults) {
  for (Fault& fault : FaultsOf(part)) {
    faults.push_back(
        {fmt::format("{}{}", prefix, fault.where), fault.what, fault.expected});
  }
}

}  // namespace

bool IsScenarioId(std::string_view id) {
  // An empty level means a leading, trailing or double slash.
  bool level_is_empty = true;
  for (const char c : id) {
    if (c == '/') {
      if (level_is_empty) return false;
      level_is_empty = true;
    } else {
      if (!IsOneOf(c, kLowerAndDigits)) return false;
      level_is_empty = false;
    }
  }
  return !level_is_empty;
}

bool IsWord(std::string_view word) {
  return IsScenarioId(word) && word.find('/') == std::string_view::npos;
}

bool IsBodyName(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return IsOneOf(c, kLowerAndDigits) || IsOneOf(c, kUpper) || c == '-';
  });
}

std::vector<Fault> FaultsOf(const ContactExpectation& expect) {
  std::vector<Fault> faults;
  if (expect.separation && !std::isfinite(*expect.separation)) {
    faults.push_back(
        {"separation", fmt::format("is {}", *expect.separation), "a finite number"});
  } else if (expect.separation && expect.touching &&
             *expect.touching != (*expect.separation <= 0)) {
    faults.push_back(
        {"separation",
         fmt::format("is {} with touching = {}", *expect.separation, *expect.touching),
         *expect.touching ? "0 or less, since the bodies touch"
                          : "more than 0, since the bodies do not touch"});
  }
  for (std::size_t i = 0; i < expect.normals.size(); ++i) {
    // Written so that a NaN is a fault.
    const double norm = expect.normals[i].stableNorm();
    if (std::abs(norm - 1) <= kNormalSlack) continue;
    faults.push_back({fmt::format("normals[{}]", i), fmt::format("has norm {}", norm),
                      fmt::format("a unit vector, to {}", kNormalSlack)});
  }
  if (expect.contacts && *expect.contacts < 0) {
    faults.push_back(
        {"contacts", fmt::format("is {}", *expect.contacts), "a count, 0 or more"});
  }
  return faults;
}

std::vector<Fault> FaultsOf(const ToleranceOverride& tolerance) {
  std::vector<Fault> faults;
  if (!(tolerance.separation > 0 && std::isfinite(tolerance.separation))) {
    faults.push_back({"separation", fmt::format("is {}", tolerance.separation),
                      "a finite length > 0"});
  }
  CheckText("because", tolerance.because, faults);
  return faults;
}

std::vector<Fault> FaultsOf(const std::vector<Indictment>& indictments) {
  std::vector<Fault> faults;
  for (std::size_t i = 0; i < indictments.size(); ++i) {
    CheckText(fmt::format("indicts[{}].oracle", i), indictments[i].oracle, faults);
    if (indictments[i].measures.empty()) {
      faults.push_back(
          {fmt::format("indicts[{}].measures", i), "is empty", "at least one measure"});
    }
    CheckText(fmt::format("indicts[{}].anomaly", i), indictments[i].anomaly, faults);
  }
  return faults;
}

std::vector<Fault> FaultsOfHeading(std::string_view id, std::string_view title,
                                   std::string_view source) {
  std::vector<Fault> faults;
  if (!IsScenarioId(id)) {
    faults.push_back({"id", fmt::format("is \"{}\"", id),
                      "levels of a-z, 0-9 and _ joined by slashes"});
  }
  CheckText("title", title, faults);
  CheckText("source", source, faults);
  return faults;
}

std::vector<Fault> FaultsOf(const Scenario& scenario) {
  std::vector<Fault> faults =
      FaultsOfHeading(scenario.id, scenario.title, scenario.source);
  CheckBodyName("contact.A", scenario.name_A, faults);
  CheckBodyName("contact.B", scenario.name_B, faults);
  if (scenario.name_A == scenario.name_B) {
    faults.push_back({"contact.B",
                      fmt::format("is \"{}\", the same as contact.A", scenario.name_B),
                      "another body"});
  }
  AppendPrefixed("", scenario.contact, faults);
  AppendPrefixed("expect.", scenario.expect, faults);
  if (scenario.tolerance) AppendPrefixed("tolerance.", *scenario.tolerance, faults);
  AppendPrefixed("", scenario.indicts, faults);
  return faults;
}

}  // namespace touchstone
