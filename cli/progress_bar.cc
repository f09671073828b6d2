#include "cli/progress_bar.h"

#include <iostream>
#include <string>

#include <fmt/format.h>

namespace touchstone {
namespace {

constexpr auto kDelay = std::chrono::seconds(2);
constexpr auto kBetweenBars = std::chrono::milliseconds(100);
constexpr auto kBetweenLines = std::chrono::seconds(10);

/** Returns a duration for a person: "40 s", "12 min", "3.5 h". */
std::string InWords(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

ProgressBar::ProgressBar(const Terminal& terminal, bool quiet)
    : is_bar_(terminal.progress) {
  if (!quiet)
    drawing_ = std::jthread([this](const std::stop_token& stop) { DrawUntil(stop); });
}

ProgressBar::~ProgressBar() {
  if (!drawing_.joinable()) return;
  drawing_.request_stop();
  drawing_.join();
  if (drawn_) std::cerr << "\r\x1b[K" << std::flush;
}

void ProgressBar::Show(std::size_t done, std::size_t total, double part) {
  const std::scoped_lock lock(mutex_);
  last_ = {Clock::now(), done, total, part};
  if (!first_) first_ = last_;
}

void ProgressBar::DrawUntil(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  const auto wait = [&](std::chrono::milliseconds time) {
    stopped_.wait_for(lock, stop, time, [] { return false; });
  };
  wait(is_bar_ ? kDelay : kBetweenLines);
  while (!stop.stop_requested()) {
    if (first_ && last_.total > 0) is_bar_ ? DrawBar() : DrawLine();
    wait(is_bar_ ? kBetweenBars : kBetweenLines);
  }
}

void ProgressBar::DrawBar() {
  constexpr std::size_t kWidth = 40;
  const auto filled = static_cast<std::size_t>(kWidth * last_.part);
  std::cerr << fmt::format("\r[{:<{}}] {} of {}\x1b[K", std::string(filled, '#'), kWidth,
                           last_.done, last_.total)
            << std::flush;
  drawn_ = true;
}

void ProgressBar::DrawLine() {
  const auto since_start = [this](Clock::time_point time) {
    return std::chrono::duration<double>(time - first_->time).count();
  };
  std::string line = fmt::format("touchstone: {} of {} after {}", last_.done, last_.total,
                                 InWords(since_start(Clock::now())));
  // The rate ends with what was done last: a long item does not lower it.
  const double seconds = since_start(last_.time);
  const double part = last_.part - first_->part;
  if (last_.done > first_->done && seconds > 0) {
    line += fmt::format(", {:.3g} a second",
                        static_cast<double>(last_.done - first_->done) / seconds);
  }
  if (part > 0)
    line += fmt::format(", {} to go", InWords(seconds * (1 - last_.part) / part));
  std::cerr << line << std::endl;
}

}  // namespace touchstone
