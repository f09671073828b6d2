#include "cli/interrupt.h"

#include <chrono>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>

namespace touchstone {
namespace {

TEST(InterruptTest, TakesASignalAndItsRepetitionAtOnceAsOneRequest) {
  const Interrupt interrupt;
  EXPECT_EQ(Interrupt::signal(), 0);
  std::raise(SIGINT);
  std::raise(SIGINT);
  EXPECT_EQ(Interrupt::signal(), SIGINT);
}

TEST(InterruptTest, EndsTheProgramAtALaterSignal) {
  const auto insist = [] {
    const Interrupt interrupt;
    std::raise(SIGTERM);
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    std::raise(SIGTERM);
  };
  EXPECT_EXIT(insist(), testing::KilledBySignal(SIGTERM), "");
}

}  // namespace
}  // namespace touchstone
