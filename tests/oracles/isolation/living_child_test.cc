#include "oracles/isolation/living_child.h"

#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include <gtest/gtest.h>
#include <unistd.h>

#include "oracles/isolation/child_process.h"

namespace touchstone {
namespace {

using std::chrono::hours;

// No test may wait for these.
constexpr ChildLimits kLimits = {hours(1), hours(1), std::size_t{1} << 30,
                                 std::size_t{1} << 24};

std::optional<std::string> AsText(std::string_view bytes) {
  return std::string(bytes);
}

// Ends this process with status 1 if it does not hold.
void Expect(bool holds) {
  if (!holds) std::_Exit(1);
}

// In a process of its own, which cannot have children afterwards.
TEST(EndChildren, EndsThoseThatAreAtWorkAndRefusesOthers) {
  const auto deed = [] {
    ChildProcess child(kLimits, [](ChildContext& parent) {
      parent.Send("at work");
      for (;;) pause();
    });
    Expect(child.Receive(&AsText) == "at work");
    EndChildren();
    Expect(child.Receive(&AsText) == std::nullopt);
    Expect(child.End().reason == "killed by SIGKILL");
    try {
      const ChildProcess another(kLimits, [](ChildContext&) {});
    } catch (const std::system_error&) {
      std::_Exit(0);
    }
    std::_Exit(2);
  };
  EXPECT_EXIT(deed(), testing::ExitedWithCode(0), "");
}

TEST(EndChildren, DoesNothingInAChild) {
  const auto deed = [] {
    ChildProcess sibling(kLimits, [](ChildContext& parent) {
      for (;;) parent.Send(std::string(parent.Receive()));
    });
    ChildProcess child(kLimits, [](ChildContext& parent) {
      EndChildren();
      parent.Send("has ended its siblings");
    });
    Expect(child.Receive(&AsText) == "has ended its siblings");
    sibling.Send("alive");
    Expect(sibling.Receive(&AsText) == "alive");
    std::_Exit(0);
  };
  EXPECT_EXIT(deed(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace touchstone
