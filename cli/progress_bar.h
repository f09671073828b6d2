#pragma once

#include <chrono>
#include <cstddef>

namespace touchstone {

/** A progress bar on standard error, for work that takes longer than two seconds. The
 destructor erases it. */
class ProgressBar {
 public:
  explicit ProgressBar(bool enabled);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void Show(std::size_t done, std::size_t total);

 private:
  using Clock = std::chrono::steady_clock;

  bool enabled_;
  bool drawn_ = false;
  Clock::time_point next_;  ///< Time of the next drawing.
};

}  // namespace touchstone
