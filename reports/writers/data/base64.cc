#include "reports/writers/data/base64.h"

#include <cstdint>

namespace touchstone {

std::string Base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_inside = i + k < bytes.size();
      three = three << 8 | (is_inside ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      // One byte fills two digits, two bytes three.
      const bool is_padding = i + k > bytes.size();
      text += is_padding ? '=' : kDigits[three >> (18 - 6 * k) & 63U];
    }
  }
  return text;
}

}  // namespace touchstone
