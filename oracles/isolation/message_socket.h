#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "oracles/isolation/unique_fd.h"

namespace touchstone {

/** One end of a stream socket that sends and receives whole messages of bytes. A message
 is its length as a u64 in the machine's byte order, then its bytes. */
class MessageSocket {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /** Why there is no next message. */
  enum class Silence {
    kClosed,   ///< The other end is closed.
    kInvalid,  ///< The last message was too long, or was rejected.
    kLate,     ///< The deadline passed.
  };

  /** A socket without another end. */
  MessageSocket() = default;

  /** Takes a connected socket. A message longer than `longest` [bytes] is invalid. */
  MessageSocket(UniqueFd socket, std::size_t longest)
      : socket_(std::move(socket)), longest_(longest) {}

  /** Returns whether the whole message was sent. Blocks while the other end does not
   receive. */
  bool Send(std::string_view message);

  /** Returns `message` with its length before it. */
  static std::string Framed(std::string_view message);

  /** Waits until the other end is closed, and returns whether it is. Bytes that arrive
   are ignored. */
  bool AwaitClosing(Time deadline);

  /** Expects no more of the other end, which has said nothing for too long. */
  void GiveUp() { silence_ = Silence::kLate; }

  /** Waits for the next message and returns its bytes, valid until the next call. After
   it has returned nothing, it returns nothing at once. */
  std::optional<std::string_view> Receive(Time deadline = Time::max());

  /** Declares the last message invalid and all later ones unwanted. */
  void Reject() { silence_ = Silence::kInvalid; }

  /** Returns why there is no next message; empty while there may be one. */
  std::optional<Silence> silence() const { return silence_; }

 private:
  void Read(Time deadline);

  UniqueFd socket_;
  std::size_t longest_ = 0;
  std::string received_;
  std::size_t taken_ = 0;  // Bytes of received_ that Receive() has returned.
  std::optional<Silence> silence_;
};

}  // namespace touchstone
