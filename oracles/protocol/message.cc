#include "oracles/protocol/message.h"

#include <bit>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

namespace touchstone {

// Every processor that the engines run on is little-endian; a frame is its memory.
static_assert(std::endian::native == std::endian::little);

namespace {

// Throws unless the text is one that the parser can be trusted with: it compares a key
// with all others of its object, and prints and destroys nested values by recursion. No
// message is near these limits.
void ExpectReadable(std::string_view text) {
  constexpr int kMostNested = 64;
  constexpr int kMostKeys = 100'000;
  int nested = 0;
  int keys = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      in_string = c != '"';
      continue;
    }
    in_string = c == '"';
    if (c == '[' || c == '{') ++nested;
    if (c == ']' || c == '}') --nested;
    if (c == ':') ++keys;
    if (nested > kMostNested || keys > kMostKeys) {
      throw ProtocolError(
          fmt::format("sent a line with {}; expected at most {} nested lists and {} keys",
                      nested > kMostNested ? "too many nested lists" : "too many keys",
                      kMostNested, kMostKeys));
    }
  }
}

}  // namespace

std::string BytesOf(Message message) {
  const std::size_t size = message.frame.size() * sizeof(double);
  if (size > 0) message.line["frame"] = size;
  std::string bytes = OneLine(message.line);
  bytes += '\n';
  const std::size_t line = bytes.size();
  bytes.resize(line + size);
  if (size > 0) std::memcpy(bytes.data() + line, message.frame.data(), size);
  return bytes;
}

Json LineFrom(std::string_view text) {
  ExpectReadable(text);
  // Without an exception, an error of the parser is a discarded value.
  Json line = Json::parse(text, nullptr, false);
  if (line.is_object()) return line;
  constexpr std::size_t kShown = 60;
  throw ProtocolError(fmt::format("sent \"{}{}\"; expected a line of JSON, an object",
                                  text.substr(0, kShown),
                                  text.size() > kShown ? " …" : ""));
}

std::size_t FrameSizeOf(const Json& line, std::size_t most) {
  const auto found = line.find("frame");
  if (found == line.end() || found->is_null()) return 0;
  const double size = found->is_number() ? found->get<double>() : -1;
  constexpr double kUnit = sizeof(double);
  if (size >= 0 && size <= static_cast<double>(most) && std::fmod(size, kUnit) == 0)
    return static_cast<std::size_t>(size);
  Received(*found, "frame").Fail(fmt::format("a multiple of 8, at most {}", most));
}

std::vector<double> FrameFrom(std::string_view bytes) {
  std::vector<double> numbers(bytes.size() / sizeof(double));
  if (!numbers.empty())
    std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
  return numbers;
}

Eigen::Vector3d FrameReader::Vector() {
  const std::span<const double> v = Numbers(3);
  return {v[0], v[1], v[2]};
}

std::span<const double> FrameReader::Numbers(std::size_t count) {
  if (count > rest_.size()) {
    throw ProtocolError(fmt::format("frame: ends after {} numbers; expected {} more",
                                    taken_ + rest_.size(), count - rest_.size()));
  }
  const std::span<const double> numbers = rest_.first(count);
  rest_ = rest_.subspan(count);
  taken_ += count;
  return numbers;
}

std::size_t FrameReader::Count(std::size_t least) {
  const double count = Number();
  if (count >= 0 && count == std::floor(count) &&
      count * static_cast<double>(least) <= static_cast<double>(rest_.size())) {
    return static_cast<std::size_t>(count);
  }
  throw ProtocolError(fmt::format(
      "frame: number {} is {}; expected a count of items that the frame has room for",
      taken_ - 1, count));
}

void FrameReader::ExpectEnd() const {
  if (rest_.empty()) return;
  throw ProtocolError(
      fmt::format("frame: {} numbers after its end; expected none", rest_.size()));
}

void Append(std::vector<double>& frame, const Eigen::Vector3d& v) {
  frame.insert(frame.end(), v.begin(), v.end());
}

}  // namespace touchstone
