#include "cli/interrupt.h"

#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include <gtest/gtest.h>

#include "oracles/isolation/child_process.h"

namespace touchstone {
namespace {

TEST(InterruptTest, TakesASignalAndItsRepetitionAtOnceAsOneRequest) {
  const Interrupt interrupt(WorkingEngines::kFinish);
  EXPECT_EQ(Interrupt::signal(), 0);
  std::raise(SIGINT);
  std::raise(SIGINT);
  EXPECT_EQ(Interrupt::signal(), SIGINT);
}

TEST(InterruptTest, EndsTheProgramAtALaterSignal) {
  const auto insist = [] {
    const Interrupt interrupt(WorkingEngines::kFinish);
    std::raise(SIGTERM);
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    std::raise(SIGTERM);
  };
  EXPECT_EXIT(insist(), testing::KilledBySignal(SIGTERM), "");
}

TEST(InterruptTest, EndsAnEngineAtWorkIfItIsTold) {
  using std::chrono::hours;
  const auto is_answered = [](WorkingEngines engines) {
    constexpr ChildLimits kLimits = {hours(1), hours(1), std::size_t{1} << 30,
                                     std::size_t{1} << 20};
    const auto as_text = [](std::string_view bytes) {
      return std::optional<std::string>(bytes);
    };
    ChildProcess engine(kLimits, [](ChildContext& parent) {
      parent.Send("at work");
      parent.Send(std::string(parent.Receive()));
    });
    if (!engine.Receive<std::string>(as_text)) std::_Exit(2);
    const Interrupt interrupt(engines);
    std::raise(SIGINT);
    engine.Send("the answer");
    std::_Exit(engine.Receive<std::string>(as_text) ? 1 : 0);
  };
  EXPECT_EXIT(is_answered(WorkingEngines::kFinish), testing::ExitedWithCode(1), "");
  EXPECT_EXIT(is_answered(WorkingEngines::kEnd), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace touchstone
