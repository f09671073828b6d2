#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/protocol/json.h"

namespace touchstone {

/** The version of the protocol that this program speaks, see docs/oracle_protocol.md. */
inline constexpr int kProtocolVersion = 1;

/** A message: a line of JSON, and doubles that follow it if the line states "frame". */
// NOLINTNEXTLINE(bugprone-exception-escape): the move of nlohmann's JSON only asserts.
struct Message {
  Json line;
  std::vector<double> frame;
};

/** Returns the bytes of `message`, whose line gets "frame", the size in bytes, if there
 are doubles. They are little-endian. */
std::string BytesOf(Message message);

/** Returns the line of a message from its text.
 @throws ProtocolError if it is not an object in JSON. */
Json LineFrom(std::string_view text);

/** Returns the size of the frame after `line`; 0 if it has none. [bytes]
 @throws ProtocolError unless it is a multiple of 8 up to `most`. */
std::size_t FrameSizeOf(const Json& line, std::size_t most);

/** Returns the doubles in the bytes of a frame. @pre Their number is a multiple of 8. */
std::vector<double> FrameFrom(std::string_view bytes);

/** Takes numbers from the front of a frame. Throws ProtocolError beyond its end. */
class FrameReader {
 public:
  explicit FrameReader(std::span<const double> numbers) : rest_(numbers) {}

  double Number() { return Numbers(1).front(); }
  Eigen::Vector3d Vector();

  /** Returns the next `count` numbers. */
  std::span<const double> Numbers(std::size_t count);

  /** Returns a count of items, which have at least `least` numbers each. */
  std::size_t Count(std::size_t least);

  /** Throws unless every number has been taken. */
  void ExpectEnd() const;

 private:
  std::span<const double> rest_;
  std::size_t taken_ = 0;
};

/** Appends to a frame. */
void Append(std::vector<double>& frame, const Eigen::Vector3d& v);

}  // namespace touchstone
