#include "reports/bench/stepping_child.h"

#include <cstddef>
#include <cstring>
#include <memory>
#include <string_view>
#include <type_traits>

namespace touchstone {
namespace {

// Address space per thread, beyond that in use at the fork. [bytes]
constexpr std::size_t kMemory = std::size_t{4} << 30;
constexpr std::size_t kLongestMessage = 64;  // [bytes]

template <typename Plain>
std::string_view AsBytes(const Plain& message) {
  static_assert(std::is_trivially_copyable_v<Plain> && sizeof(Plain) <= kLongestMessage);
  return {reinterpret_cast<const char*>(&message), sizeof(message)};
}

template <typename Plain>
std::optional<Plain> FromBytes(std::string_view bytes) {
  Plain message;
  if (bytes.size() != sizeof(message)) return std::nullopt;
  std::memcpy(&message, bytes.data(), sizeof(message));
  return message;
}

ChildLimits LimitsOf(const Stepping& stepping) {
  return {stepping.cpu, stepping.wall,
          kMemory * static_cast<std::size_t>(stepping.threads), kLongestMessage};
}

// An order is a number of steps, or 0 for the quality.
[[noreturn]] void Serve(ChildContext& parent, const Oracle& oracle, const World& world,
                        int threads) {
  parent.StartTask();
  const std::unique_ptr<Simulation> simulation =
      threads == 1 ? oracle.BeginAsShipped(world) : oracle.BeginInThreads(world, threads);
  for (;;) {
    const int steps = FromBytes<int>(parent.Receive()).value();
    if (steps > 0) {
      parent.Send(AsBytes(TimeSteps(*simulation, steps)));
    } else {
      WorldState state;
      simulation->Read(state);
      parent.Send(AsBytes(QualityOf(world, state)));
    }
  }
}

}  // namespace

SteppingChild::SteppingChild(const Oracle& oracle, const World& world,
                             const Stepping& stepping)
    : child_(LimitsOf(stepping), [&](ChildContext& parent) {
        Serve(parent, oracle, world, stepping.threads);
      }) {}

std::optional<StepTime> SteppingChild::Step(int steps) {
  child_.Send(AsBytes(steps));
  return child_.Receive(&FromBytes<StepTime>);
}

std::optional<WorldQuality> SteppingChild::Quality() {
  child_.Send(AsBytes(0));
  return child_.Receive(&FromBytes<WorldQuality>);
}

}  // namespace touchstone
