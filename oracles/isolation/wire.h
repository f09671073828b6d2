#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include <Eigen/Core>

namespace touchstone {

/** Writes values as bytes for a process of the same program on the same machine. */
class WireWriter {
 public:
  template <typename Number>
  void Put(Number number) {
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof(number));
  }
  void Put(const Eigen::Vector3d& v) {
    for (const double x : v) Put(x);
  }
  void Put(std::string_view text) {
    Put(static_cast<std::uint32_t>(text.size()));
    bytes_.append(text);
  }
  std::string Take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/** Reads values from the front of some bytes, which may be anything. After a failure it
 returns zeros only. */
class WireReader {
 public:
  explicit WireReader(std::string_view bytes) : rest_(bytes) {}

  template <typename Number>
  Number Get() {
    Number number{};
    if (rest_.size() < sizeof(number)) {
      Fail();
      return number;
    }
    std::memcpy(&number, rest_.data(), sizeof(number));
    rest_.remove_prefix(sizeof(number));
    return number;
  }
  Eigen::Vector3d GetVector() {
    const double x = Get<double>();
    const double y = Get<double>();
    const double z = Get<double>();
    return {x, y, z};
  }
  std::string GetText() {
    const auto length = Get<std::uint32_t>();
    if (length > rest_.size()) {
      Fail();
      return {};
    }
    std::string text(rest_.substr(0, length));
    rest_.remove_prefix(length);
    return text;
  }
  /** Reads a count of items. Fails if the remaining bytes cannot hold that many, each of
   at least `smallest` bytes. */
  template <typename Count = std::uint32_t>
  Count GetCount(std::size_t smallest) {
    const auto count = Get<Count>();
    if (count > rest_.size() / smallest) {
      Fail();
      return 0;
    }
    return count;
  }
  void Fail() {
    failed_ = true;
    rest_ = {};
  }
  bool AtEndWithoutFailure() const { return !failed_ && rest_.empty(); }

 private:
  std::string_view rest_;
  bool failed_ = false;
};

}  // namespace touchstone
