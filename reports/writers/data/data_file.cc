#include "reports/writers/data/data_file.h"

#include <cstdint>

#include <fmt/format.h>

#include "reports/writers/data/deflate.h"

namespace touchstone {
namespace {

constexpr std::string_view kMagic = "TSRD";

void AppendU32(std::size_t number, std::string& bytes) {
  for (int shift = 0; shift < 32; shift += 8)
    bytes += static_cast<char>(number >> shift & 0xff);
}

std::uint32_t U32At(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t k = 0; k < 4; ++k)
    number |= std::uint32_t{static_cast<unsigned char>(bytes[at + k])} << 8 * k;
  return number;
}

/** The most levels of nested JSON. The format has eight. The library copies and writes a
 document by recursion: at 60,000 levels the stack overflows. */
constexpr int kDeepest = 64;

/** Returns whether the arrays and objects of a JSON text are nested beyond `most` levels.
 */
bool IsNestedBeyond(int most, std::string_view json) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t k = 0; k < json.size(); ++k) {
    const char c = json[k];
    if (in_string) {
      if (c == '\\') ++k;
      in_string = c != '"';
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > most) return true;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

}  // namespace

std::string PackData(const DataFile& file) {
  // Text from a third-party engine may not be valid UTF-8.
  const std::string json =
      file.json.dump(-1, ' ', false, DataJson::error_handler_t::replace);
  std::string bytes(kMagic);
  AppendU32(kReportDataVersion, bytes);
  AppendU32(json.size(), bytes);
  return Deflated(bytes + json + file.blob);
}

Unpacked UnpackData(std::string_view bytes, std::size_t most) {
  constexpr std::size_t kHead = 12;
  const std::optional<std::string> inflated = Inflated(bytes, most);
  if (!inflated || inflated->size() < kHead || !inflated->starts_with(kMagic))
    return {std::nullopt, "is no report data"};
  const std::string_view all = *inflated;
  if (const std::uint32_t version = U32At(all, 4); version != kReportDataVersion) {
    return {std::nullopt, fmt::format("has version {} of the format, not {}", version,
                                      kReportDataVersion)};
  }
  const std::size_t length = U32At(all, 8);
  if (length > all.size() - kHead) return {std::nullopt, "is cut off"};
  if (IsNestedBeyond(kDeepest, all.substr(kHead, length)))
    return {std::nullopt, fmt::format("has JSON of more than {} levels", kDeepest)};
  DataJson json = DataJson::parse(all.substr(kHead, length), nullptr, false);
  if (!json.is_object()) return {std::nullopt, "has no JSON in it"};
  return {DataFile{std::move(json), std::string(all.substr(kHead + length))}, ""};
}

}  // namespace touchstone
