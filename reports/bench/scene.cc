#include "reports/bench/scene.h"

#include <array>

#include "scenarios/generators/crowds.h"

namespace touchstone {
namespace {

constexpr std::array kScenes = {
    Scene{"boxes100", "a pile of 100 boxes", "boxes", 100,
          [](std::uint64_t s) { return BoxPile(100, s); }},
    Scene{"boxes1000", "a pile of 1,000 boxes", "boxes", 1000,
          [](std::uint64_t s) { return BoxPile(1000, s); }},
    Scene{"boxes10000", "a pile of 10,000 boxes", "boxes", 10000,
          [](std::uint64_t s) { return BoxPile(10000, s); }},
    Scene{"boxes30000", "a pile of 30,000 boxes", "boxes", 30000,
          [](std::uint64_t s) { return BoxPile(30000, s); }},
    Scene{"stack20", "a stack of 20 boxes", "stacked boxes", 20,
          [](std::uint64_t) { return BoxStack(20); }},
    Scene{"spheres10000", "a pile of 10,000 spheres", "spheres", 10000,
          [](std::uint64_t s) { return SpherePile(10000, s); }},
};

}  // namespace

std::span<const Scene> Scenes() {
  return kScenes;
}

std::vector<std::string> SceneNames() {
  std::vector<std::string> names;
  names.reserve(kScenes.size());
  for (const Scene& scene : kScenes) names.emplace_back(scene.name);
  return names;
}

}  // namespace touchstone
