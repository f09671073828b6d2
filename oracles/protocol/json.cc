#include "oracles/protocol/json.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace touchstone {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Json ToJson(double number) {
  if (std::isnan(number)) return "NaN";
  if (std::isinf(number)) return number > 0 ? "Infinity" : "-Infinity";
  return number;
}

Json ToJson(const Eigen::Vector3d& v) {
  return Json::array({ToJson(v.x()), ToJson(v.y()), ToJson(v.z())});
}

std::string OneLine(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Received Received::operator[](std::string_view key) const {
  if (const std::optional<Received> value = Find(key)) return *value;
  throw ProtocolError(fmt::format("{}: expected \"{}\" in it", place_, key));
}

std::optional<Received> Received::Find(std::string_view key) const {
  if (!json_->is_object()) Fail("an object");
  const auto found = json_->find(key);
  if (found == json_->end() || found->is_null()) return std::nullopt;
  return Received(*found, fmt::format("{}.{}", place_, key));
}

std::vector<Received> Received::Items() const {
  if (!json_->is_array()) Fail("a list");
  std::vector<Received> items;
  items.reserve(json_->size());
  for (const Json& item : *json_)
    items.emplace_back(item, fmt::format("{}[{}]", place_, items.size()));
  return items;
}

std::vector<Received> Received::Items(std::size_t count) const {
  if (!json_->is_array() || json_->size() != count)
    Fail(fmt::format("a list of {}", count));
  return Items();
}

std::vector<std::string> Received::Keys() const {
  if (!json_->is_object()) Fail("an object");
  std::vector<std::string> keys;
  for (const auto& item : json_->items()) keys.push_back(item.key());
  return keys;
}

double Received::Number() const {
  if (json_->is_number()) return json_->get<double>();
  if (json_->is_null() || *json_ == "NaN") return kNaN;
  if (*json_ == "Infinity") return kInfinity;
  if (*json_ == "-Infinity") return -kInfinity;
  Fail("a number");
}

int Received::Whole(int least, int most) const {
  const double number = json_->is_number() ? json_->get<double>() : kNaN;
  if (!(number >= least && number <= most) || number != std::floor(number))
    Fail(fmt::format("a whole number from {} to {}", least, most));
  return static_cast<int>(number);
}

bool Received::Truth() const {
  if (!json_->is_boolean()) Fail("true or false");
  return json_->get<bool>();
}

std::string Received::Text() const {
  if (!json_->is_string()) Fail("a string");
  return json_->get<std::string>();
}

Eigen::Vector3d Received::Vector() const {
  if (!json_->is_array() || json_->size() != 3) Fail("a list of 3 numbers");
  Eigen::Vector3d v;
  for (int i = 0; i < 3; ++i) {
    const Json& number = (*json_)[static_cast<std::size_t>(i)];
    v[i] = Received(number, fmt::format("{}[{}]", place_, i)).Number();
  }
  return v;
}

void Received::Fail(std::string_view expected) const {
  // Long enough to recognise the value, short enough for a line of a report.
  constexpr std::size_t kShown = 60;
  std::string value = OneLine(*json_);
  if (value.size() > kShown) value = value.substr(0, kShown) + " …";
  throw ProtocolError(fmt::format("{}: {}; expected {}", place_, value, expected));
}

}  // namespace touchstone
