#pragma once

#include <cstdint>
#include <string_view>

namespace touchstone {

/** The FNV-1a hash of 64 bits (Fowler, Noll & Vo), the same on every machine. */
class Fnv1a {
 public:
  void Take(std::string_view bytes) {
    for (const char byte : bytes) {
      value_ ^= static_cast<unsigned char>(byte);
      value_ *= 1099511628211U;
    }
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037U;
};

}  // namespace touchstone
