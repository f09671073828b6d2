#pragma once

#include <chrono>

namespace touchstone {

/** The time since it was made, by the clock on the wall. */
class Stopwatch {
 public:
  /** [s] */
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_)
        .count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace touchstone
