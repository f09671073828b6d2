#pragma once

#include <chrono>
#include <cstddef>
#include <optional>

#include "cli/terminal.h"

namespace touchstone {

/** Progress on standard error, for work that takes longer than two seconds. On a terminal
 it is a bar, which the destructor erases; elsewhere it is a line every ten seconds. */
class ProgressBar {
 public:
  /** Shows nothing if `quiet`. */
  ProgressBar(const Terminal& terminal, bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void Show(std::size_t done, std::size_t total);

 private:
  using Clock = std::chrono::steady_clock;

  void ShowLine(std::size_t done, std::size_t total);

  bool quiet_;
  bool is_bar_;
  bool drawn_ = false;
  Clock::time_point next_;  ///< Time of the next drawing.
  /** Start of the work, and what was done then. */
  std::optional<Clock::time_point> start_;
  std::size_t done_at_start_ = 0;
};

}  // namespace touchstone
