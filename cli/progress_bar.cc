#include "cli/progress_bar.h"

#include <iostream>
#include <string>

#include <fmt/format.h>

namespace touchstone {
namespace {

constexpr auto kDelay = std::chrono::seconds(2);
constexpr auto kBetweenDrawings = std::chrono::milliseconds(100);
constexpr auto kBetweenLines = std::chrono::seconds(10);

/** Returns a duration for a person: "40 s", "12 min", "3.5 h". */
std::string InWords(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

ProgressBar::ProgressBar(const Terminal& terminal, bool quiet)
    : quiet_(quiet),
      is_bar_(terminal.progress),
      next_(Clock::now() + (is_bar_ ? kDelay : kBetweenLines)) {}

ProgressBar::~ProgressBar() {
  if (drawn_) std::cerr << "\r\x1b[K" << std::flush;
}

void ProgressBar::Show(std::size_t done, std::size_t total) {
  if (!start_) {
    start_ = Clock::now();
    done_at_start_ = done;
  }
  if (quiet_ || total == 0 || Clock::now() < next_) return;
  if (!is_bar_) {
    ShowLine(done, total);
    return;
  }
  constexpr std::size_t kWidth = 40;
  const std::size_t filled = kWidth * done / total;
  std::cerr << fmt::format("\r[{:<{}}] {} of {}\x1b[K", std::string(filled, '#'), kWidth,
                           done, total)
            << std::flush;
  drawn_ = true;
  next_ = Clock::now() + kBetweenDrawings;
}

void ProgressBar::ShowLine(std::size_t done, std::size_t total) {
  const double seconds = std::chrono::duration<double>(Clock::now() - *start_).count();
  const double rate = static_cast<double>(done - done_at_start_) / seconds;
  std::string line =
      fmt::format("touchstone: {} of {}, {:.3g} a second", done, total, rate);
  if (rate > 0)
    line += fmt::format(", {} to go", InWords(static_cast<double>(total - done) / rate));
  std::cerr << line << std::endl;
  next_ = Clock::now() + kBetweenLines;
}

}  // namespace touchstone
