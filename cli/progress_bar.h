#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "cli/terminal.h"

namespace touchstone {

/** Progress on standard error, for work that takes longer than two seconds. On a terminal
 it is a bar, which the destructor erases; elsewhere it is a line every ten seconds. A
 thread draws it, so that one long item shows that it goes on. */
class ProgressBar {
 public:
  /** Shows nothing if `quiet`. */
  ProgressBar(const Terminal& terminal, bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void Show(std::size_t done, std::size_t total) {
    Show(done, total,
         total == 0 ? 0 : static_cast<double>(done) / static_cast<double>(total));
  }

  /** The same for items that take unequal times.
   @param part The part of the work that is done, in [0, 1]. */
  void Show(std::size_t done, std::size_t total, double part);

 private:
  using Clock = std::chrono::steady_clock;

  /** The items and the part of the work, in [0, 1], that are done at a time. */
  struct State {
    Clock::time_point time;
    std::size_t done = 0;
    std::size_t total = 0;
    double part = 0;
  };

  void DrawUntil(const std::stop_token& stop);
  void DrawBar();
  void DrawLine();

  bool is_bar_;
  bool drawn_ = false;
  std::mutex mutex_;
  std::condition_variable_any stopped_;
  std::optional<State> first_;  ///< The state that was shown first.
  State last_;                  ///< The state that was shown last.
  std::jthread drawing_;        ///< Not running if the bar is quiet.
};

}  // namespace touchstone
