#include "oracles/isolation/message_socket.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>

#include <poll.h>
#include <sys/socket.h>

namespace touchstone {

using std::chrono::milliseconds;

bool MessageSocket::Send(std::string_view message) {
  const std::string framed = Framed(message);
  for (std::string_view rest = framed; !rest.empty();) {
    const ssize_t count = send(socket_.get(), rest.data(), rest.size(), MSG_NOSIGNAL);
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) rest.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

std::string MessageSocket::Framed(std::string_view message) {
  const std::uint64_t length = message.size();
  std::string framed;
  framed.reserve(sizeof(length) + message.size());
  framed.append(reinterpret_cast<const char*>(&length), sizeof(length));
  framed += message;
  return framed;
}

bool MessageSocket::AwaitClosing(Time deadline) {
  while (!silence_) {
    Read(deadline);
    received_.clear();
  }
  if (silence_ == Silence::kClosed) return true;
  silence_.reset();  // Late, but not given up.
  return false;
}

std::optional<std::string_view> MessageSocket::Receive(Time deadline) {
  received_.erase(0, taken_);
  taken_ = 0;
  while (!silence_) {
    std::uint64_t length = 0;
    if (received_.size() < sizeof(length)) {
      Read(deadline);
      continue;
    }
    std::memcpy(&length, received_.data(), sizeof(length));
    if (length > longest_) {
      silence_ = Silence::kInvalid;
    } else if (received_.size() - sizeof(length) < length) {
      Read(deadline);
    } else {
      taken_ = sizeof(length) + length;
      return std::string_view(received_).substr(sizeof(length), length);
    }
  }
  return std::nullopt;
}

// Waits for bytes and appends them, or sets the reason why there are none.
void MessageSocket::Read(Time deadline) {
  constexpr milliseconds kLongestPoll = std::chrono::hours(1);
  for (;;) {
    const auto left =
        std::chrono::ceil<milliseconds>(deadline - std::chrono::steady_clock::now());
    if (left.count() <= 0) {
      silence_ = Silence::kLate;
      return;
    }
    pollfd waiting{socket_.get(), POLLIN, 0};
    const int ready =
        poll(&waiting, 1, static_cast<int>(std::min(left, kLongestPoll).count()));
    if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
    std::array<char, 1 << 16> bytes;
    const ssize_t count = recv(socket_.get(), bytes.data(), bytes.size(), 0);
    if (count < 0 && errno == EINTR) continue;
    if (count > 0)
      received_.append(bytes.data(), static_cast<std::size_t>(count));
    else
      silence_ = Silence::kClosed;
    return;
  }
}

}  // namespace touchstone
