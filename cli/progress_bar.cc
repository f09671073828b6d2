#include "cli/progress_bar.h"

#include <iostream>
#include <string>

#include <fmt/format.h>

namespace touchstone {
namespace {

constexpr auto kDelay = std::chrono::seconds(2);
constexpr auto kBetweenDrawings = std::chrono::milliseconds(100);

}  // namespace

ProgressBar::ProgressBar(bool enabled)
    : enabled_(enabled), next_(Clock::now() + kDelay) {}

ProgressBar::~ProgressBar() {
  if (drawn_) std::cerr << "\r\x1b[K" << std::flush;
}

void ProgressBar::Show(std::size_t done, std::size_t total) {
  if (!enabled_ || total == 0 || Clock::now() < next_) return;
  constexpr std::size_t kWidth = 40;
  const std::size_t filled = kWidth * done / total;
  std::cerr << fmt::format("\r[{:<{}}] {} of {}\x1b[K", std::string(filled, '#'), kWidth,
                           done, total)
            << std::flush;
  drawn_ = true;
  next_ = Clock::now() + kBetweenDrawings;
}

}  // namespace touchstone
