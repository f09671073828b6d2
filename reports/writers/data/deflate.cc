#include "reports/writers/data/deflate.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <zlib.h>

namespace touchstone {
namespace {

/** zlib reads through a pointer to non-const, but never writes there. */
Bytef* InputOf(std::string_view bytes) {
  return const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes.data()));
}

}  // namespace

std::string Deflated(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string deflated(size, '\0');
  const int status =
      compress2(reinterpret_cast<Bytef*>(deflated.data()), &size, InputOf(bytes),
                static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION);
  // The buffer holds every input, so only memory can be short.
  if (status != Z_OK) throw std::bad_alloc();
  deflated.resize(size);
  return deflated;
}

std::optional<std::string> Inflated(std::string_view bytes, std::size_t most) {
  z_stream stream{};
  if (bytes.size() > most || inflateInit(&stream) != Z_OK) return std::nullopt;
  stream.next_in = InputOf(bytes);
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string inflated;
  std::array<char, 1 << 16> block{};
  int status = Z_OK;
  while (status == Z_OK && inflated.size() <= most) {
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = static_cast<uInt>(block.size());
    status = inflate(&stream, Z_NO_FLUSH);
    inflated.append(block.data(), block.size() - stream.avail_out);
  }
  const bool is_whole =
      status == Z_STREAM_END && stream.avail_in == 0 && inflated.size() <= most;
  inflateEnd(&stream);
  if (!is_whole) return std::nullopt;
  return inflated;
}

}  // namespace touchstone
