#include "reports/worlds/laws/double_pendulum.h"

#include <array>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "reports/worlds/law_support/held_by_rods.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/subjects.h"

namespace touchstone {
namespace {

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults =
      FaultsOfSubjects(world, claim, {.bodies = true, .particles = true});
  if (!faults.empty()) return faults;
  const std::vector<PointMass> points = PointMassesInOrder(world, claim);
  std::string why = points.size() == 2
                        ? WhyNoChain(world, points)
                        : fmt::format("are {} bodies or particles", points.size());
  if (!why.empty())
    return {{"about", why,
             "first a mass on a rod to a fixed point, then one on a rod to the first"}};
  if (NumberOr(claim, "until", 1) <= 0)
    faults.push_back({"numbers.until", "is not positive", "a time > 0"});
  return Joined(std::move(faults), FaultsOfNumbers(claim, {}));
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const HeldByRods held = ChainOf(motion.world, PointMassesInOrder(motion.world, claim));
  std::vector<PointState> truth = held.Start();
  double reached = 0;
  return JudgeHeld(motion, held,
                   NumberOr(claim, "until", std::numeric_limits<double>::infinity()),
                   [&](std::size_t s) {
                     const double t = motion.trajectory.times[s];
                     truth = held.system.After(truth, t - reached);
                     reached = t;
                     return truth;
                   });
}

constexpr std::array<std::string_view, 1> kNumbers = {"until"};

}  // namespace

constinit const Law kDoublePendulum = {
    .name = "double_pendulum",
    .documentation =
        "Two masses swing on two rods; about names the upper one, then the lower.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
    .smooth = true,
};

}  // namespace touchstone
