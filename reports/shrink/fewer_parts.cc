#include <algorithm>
#include <cstddef>
#include <string>

#include "reports/shrink/reductions.h"

namespace touchstone {
namespace {

/** Removes what refers to the body, particle or cloth `name`: a claim that is about
 nothing else, and expectations. */
void Forget(const std::string& name, WorldScenario& scenario) {
  std::erase_if(scenario.claims, [&](Claim& claim) {
    return std::erase(claim.about, name) > 0 && claim.about.empty();
  });
  std::erase_if(scenario.expectations, [&](const MotionExpectation& expectation) {
    const auto* const touch = std::get_if<ExpectedTouch>(&expectation.what);
    return expectation.body == name || (touch != nullptr && touch->other == name);
  });
}

/** Removes what is attached to the body or particle `index`, and adapts the indices of
 the others. */
template <typename Link>
void Detach(AnchorKind kind, int index, std::vector<Link>& links) {
  const auto on = [&](const Anchor& anchor) {
    return anchor.on == kind && anchor.index == index;
  };
  std::erase_if(links, [&](const Link& link) { return on(link.A) || on(link.B); });
  for (Link& link : links) {
    for (Anchor* const anchor : {&link.A, &link.B}) {
      if (anchor->on == kind && anchor->index > index) --anchor->index;
    }
  }
}

template <typename Part>
void Erase(std::vector<Part>& parts, std::size_t i) {
  parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i));
}

void EraseBody(WorldScenario& scenario, std::size_t i) {
  World& world = scenario.world;
  const int index = static_cast<int>(i);
  Forget(world.bodies[i].name, scenario);
  Detach(AnchorKind::kBody, index, world.springs);
  Detach(AnchorKind::kBody, index, world.joints);
  std::erase_if(world.pushes, [&](const Push& push) { return push.body == index; });
  for (Push& push : world.pushes) {
    if (push.body > index) --push.body;
  }
  Erase(world.bodies, i);
}

void EraseParticle(WorldScenario& scenario, std::size_t i) {
  World& world = scenario.world;
  Forget(world.particles[i].name, scenario);
  Detach(AnchorKind::kParticle, static_cast<int>(i), world.springs);
  Detach(AnchorKind::kParticle, static_cast<int>(i), world.joints);
  Erase(world.particles, i);
}

void EraseCloth(WorldScenario& scenario, std::size_t i) {
  Forget(scenario.world.cloths[i].name, scenario);
  Erase(scenario.world.cloths, i);
}

}  // namespace

void FewerParts(const Question& question, const Candidates& take) {
  const auto* const scenario = std::get_if<WorldScenario>(&question);
  if (scenario == nullptr) return;
  const auto each = [&](std::size_t count, auto erase) {
    for (std::size_t i = 0; i < count; ++i) {
      WorldScenario smaller = *scenario;
      erase(smaller, i);
      take(std::move(smaller));
    }
  };
  const World& world = scenario->world;
  // Blocks of halving length, as for the vertices of a hull.
  const std::size_t bodies = world.bodies.size();
  for (std::size_t block = bodies / 2; block > 1; block /= 2) {
    for (std::size_t end = bodies; end >= block; end -= block) {
      WorldScenario smaller = *scenario;
      for (std::size_t i = 0; i < block; ++i) EraseBody(smaller, end - 1 - i);
      take(std::move(smaller));
    }
  }
  each(bodies, EraseBody);
  each(world.particles.size(), EraseParticle);
  each(world.cloths.size(), EraseCloth);
  each(world.springs.size(),
       [](WorldScenario& w, std::size_t i) { Erase(w.world.springs, i); });
  each(world.joints.size(),
       [](WorldScenario& w, std::size_t i) { Erase(w.world.joints, i); });
  each(world.pushes.size(),
       [](WorldScenario& w, std::size_t i) { Erase(w.world.pushes, i); });
  each(scenario->claims.size(),
       [](WorldScenario& w, std::size_t i) { Erase(w.claims, i); });
  each(scenario->expectations.size(),
       [](WorldScenario& w, std::size_t i) { Erase(w.expectations, i); });
  each(scenario->ensemble ? 1 : 0,
       [](WorldScenario& w, std::size_t) { w.ensemble.reset(); });
  each(scenario->horizon ? 1 : 0,
       [](WorldScenario& w, std::size_t) { w.horizon.reset(); });
}

}  // namespace touchstone
