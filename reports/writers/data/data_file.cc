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
  DataJson json = DataJson::parse(all.substr(kHead, length), nullptr, false);
  if (!json.is_object()) return {std::nullopt, "has no JSON in it"};
  return {DataFile{std::move(json), std::string(all.substr(kHead + length))}, ""};
}

}  // namespace touchstone
