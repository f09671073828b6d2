#include "scenarios/generators/worlds/world_family.h"

#include <algorithm>
#include <array>

#include "scenarios/generators/worlds/world_builders.h"

namespace touchstone {
namespace {

constexpr std::array<std::string_view, 9> kNames = {
    "drops",       "impacts",      "slides",   "rods", "stacks",
    "mass_ratios", "step_lengths", "linkages", "bars"};

/** Steps per second of the families kStepLengths, kLinkages and kBars: those that
 games, simulators and controllers use, and others. [1/s] */
constexpr std::array<int, 16> kRates = {30,  40,  50,  60,  75,  90,  100, 120,
                                        144, 200, 240, 300, 400, 500, 750, 1000};

double AnyStep(Random& random) {
  return 1.0 / kRates[static_cast<std::size_t>(random.Below(kRates.size()))];
}

double UsualStep(Random& random) {
  return 1.0 / (60 << random.Below(4));
}

WorldScenario AnyDrop(WorldDraw& draw) {
  return draw.random.Coin() ? StraightDrop(draw) : TumblingDrop(draw);
}

WorldScenario AnyImpact(WorldDraw& draw) {
  switch (draw.random.Below(3)) {
    case 0:
      return SpherePair(draw);
    case 1:
      return SphereOnPlane(draw);
    default:
      return BoxOnPlane(draw);
  }
}

WorldScenario AnySlide(WorldDraw& draw) {
  switch (draw.random.Below(5)) {
    case 0:
      return SlidingBox(draw);
    case 1:
      return SlippingSphere(draw);
    case 2:
      return RollingSphere(draw);
    default:
      return FromRestOnSlope(draw);
  }
}

WorldScenario AnyRods(WorldDraw& draw) {
  switch (draw.random.Below(3)) {
    case 0:
      return Pendulum(draw);
    case 1:
      return DoublePendulum(draw);
    default:
      return HangingBars(draw);
  }
}

WorldScenario AnyStack(WorldDraw& draw) {
  return Stack(draw, 2 + draw.random.Below(5));
}

WorldScenario AnyOfTwoMasses(WorldDraw& draw) {
  draw.ratio_decades = 4;
  switch (draw.random.Below(4)) {
    case 0:
      return SpherePair(draw);
    case 1:
      return DoublePendulum(draw);
    case 2:
      return HangingBars(draw);
    default:
      return Stack(draw, 2);
  }
}

WorldScenario Any(WorldDraw& draw) {
  switch (draw.random.Below(6)) {
    case 0:
      return AnyDrop(draw);
    case 1:
      return AnyImpact(draw);
    case 2:
      return AnySlide(draw);
    case 3:
      return AnyRods(draw);
    case 4:
      return AnyStack(draw);
    default:
      return FreeFlight(draw);
  }
}

WorldScenario UpIsZ(WorldFamily family, WorldDraw& draw) {
  switch (family) {
    case WorldFamily::kDrops:
      return AnyDrop(draw);
    case WorldFamily::kImpacts:
      return AnyImpact(draw);
    case WorldFamily::kSlides:
      return AnySlide(draw);
    case WorldFamily::kRods:
      return AnyRods(draw);
    case WorldFamily::kStacks:
      return AnyStack(draw);
    case WorldFamily::kMassRatios:
      return AnyOfTwoMasses(draw);
    case WorldFamily::kStepLengths:
      return Any(draw);
    case WorldFamily::kLinkages:
      return Linkage(draw);
    case WorldFamily::kBars:
      return Bars(draw);
  }
  return {};
}

}  // namespace

std::vector<WorldFamily> AllWorldFamilies() {
  std::vector<WorldFamily> families;
  for (std::size_t i = 0; i < kNames.size(); ++i)
    families.push_back(static_cast<WorldFamily>(i));
  return families;
}

std::string_view NameOf(WorldFamily family) {
  return kNames[static_cast<std::size_t>(family)];
}

std::optional<WorldFamily> WorldFamilyNamed(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<WorldFamily>(found - kNames.begin());
}

WorldScenario GenerateWorld(WorldFamily family, std::uint64_t seed, std::uint64_t index) {
  // The constant keeps worlds apart from the contact questions of the same seed.
  constexpr std::uint64_t kWorlds = 0x776f726c64;
  Random random({seed, index, static_cast<std::uint64_t>(family), kWorlds});
  const bool steps_vary = family == WorldFamily::kStepLengths ||
                          family == WorldFamily::kLinkages ||
                          family == WorldFamily::kBars;
  WorldDraw draw{.random = random,
                 .dt = steps_vary ? AnyStep(random) : UsualStep(random)};
  WorldScenario scenario = UpIsZ(family, draw);
  // In half of all worlds, no face, no slope and no load is along an axis.
  if (random.Coin()) Turn(random.Rotation(), scenario.world);
  return scenario;
}

}  // namespace touchstone
