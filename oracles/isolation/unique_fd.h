#pragma once

#include <utility>

#include <unistd.h>

namespace touchstone {

/** The owner of a file descriptor. */
class UniqueFd {
 public:
  /** Owns `fd`, or nothing if it is negative. */
  explicit UniqueFd(int fd = -1) : fd_(fd) {}
  ~UniqueFd() { Reset(); }
  UniqueFd(UniqueFd&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  UniqueFd& operator=(UniqueFd&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }

  int get() const { return fd_; }

  /** Closes the descriptor. */
  void Reset() {
    if (fd_ >= 0) close(std::exchange(fd_, -1));
  }

 private:
  int fd_;
};

}  // namespace touchstone
