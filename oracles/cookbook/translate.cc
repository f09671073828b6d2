#include "oracles/cookbook/translate.h"

#include "oracles/no_answer.h"

namespace touchstone {
namespace {

constexpr const char* kNoRecipe = "the cookbook has recipes for spheres and boxes only";

bool HasRecipe(ShapeKind a, ShapeKind b) {
  const auto known = [](ShapeKind kind) {
    return kind == ShapeKind::kSphere || kind == ShapeKind::kBox;
  };
  return known(a) && known(b);
}

Capability CapabilityOf(ShapeKind a, ShapeKind b) {
  Capability capability;
  if (!HasRecipe(a, b)) {
    capability.reason = kNoRecipe;
    return capability;
  }
  const bool boxes = a == ShapeKind::kBox && b == ShapeKind::kBox;
  capability.supported = true;
  capability.family = boxes ? "sat" : "closed_form";
  capability.depth = true;
  capability.distance = !boxes;
  capability.normal = true;
  capability.manifold = true;
  return capability;
}

}  // namespace

ContactAnswer NoRecipe() {
  return UnsupportedAnswer(kNoRecipe);
}

decltype(OracleInfo::capabilities) SphereAndBoxCapabilities() {
  return CapabilityTable(CapabilityOf);
}

ContactAnswer ToAnswer(const cookbook::Manifold& manifold, bool exact_when_apart) {
  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  answer.touching = manifold.touching;
  answer.n_AB_W = manifold.n_AB_W;
  if (manifold.touching || exact_when_apart) answer.separation = manifold.separation;
  answer.points.reserve(static_cast<std::size_t>(manifold.count));
  for (const cookbook::ContactPoint& contact : manifold.points()) {
    answer.points.push_back({contact.p_WC, contact.separation, std::nullopt});
  }
  return answer;
}

}  // namespace touchstone
