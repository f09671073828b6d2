#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace touchstone {

/** JSON whose keys stay in the order in which they were written. */
using Json = nlohmann::ordered_json;

/** A message that does not follow docs/oracle_protocol.md. Its text names the place and
 what is expected there: "answers[3].normal: expected a list of 3 numbers". */
class ProtocolError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/** Returns `number`; one that is not finite as "NaN", "Infinity" or "-Infinity", because
 JSON has no such numbers. */
Json ToJson(double number);
Json ToJson(const Eigen::Vector3d& v);

/** Returns `json` on one line, with "?" in place of bytes that are not UTF-8. */
std::string OneLine(const Json& json);

/** A value in a received message, with its place. Every function throws ProtocolError if
 the value is not what it returns. */
class Received {
 public:
  /** @param json Must live longer. */
  Received(const Json& json, std::string place)
      : json_(&json), place_(std::move(place)) {}

  /** Returns the value under `key` of this object. */
  Received operator[](std::string_view key) const;

  /** Returns the value under `key` of this object; nothing if it is absent or null. */
  std::optional<Received> Find(std::string_view key) const;

  /** Returns the items of this list. */
  std::vector<Received> Items() const;

  /** Returns the items of this list, which has `count` of them. */
  std::vector<Received> Items(std::size_t count) const;

  /** Returns the keys of this object, in their order. */
  std::vector<std::string> Keys() const;

  /** Returns a number, which may also be written "NaN", "Infinity", "-Infinity", or null
   for NaN, as JavaScript does. */
  double Number() const;

  /** Returns a whole number from `least` to `most`. */
  int Whole(int least, int most) const;

  bool Truth() const;
  std::string Text() const;
  Eigen::Vector3d Vector() const;

  /** Throws that this value is not what is `expected`. */
  [[noreturn]] void Fail(std::string_view expected) const;

 private:
  const Json* json_;
  std::string place_;
};

}  // namespace touchstone
