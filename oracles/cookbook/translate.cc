#include "oracles/cookbook/translate.h"

#include <string>

#include "oracles/no_answer.h"

namespace touchstone {
namespace {

std::string NoRecipeReason(ShapeKind a, ShapeKind b) {
  return "the cookbook has no recipe for " + std::string(NameOf(a)) + " against " +
         std::string(NameOf(b));
}

}  // namespace

bool HasRecipe(ShapeKind a, ShapeKind b) {
  const auto known = [](ShapeKind kind) {
    return kind == ShapeKind::kSphere || kind == ShapeKind::kBox;
  };
  return known(a) && known(b);
}

ContactAnswer NoRecipe(const ContactQuery& query) {
  return UnsupportedAnswer(NoRecipeReason(KindOf(query.A.shape), KindOf(query.B.shape)));
}

decltype(OracleInfo::capabilities) SphereAndBoxCapabilities() {
  decltype(OracleInfo::capabilities) capabilities;
  for (int a = 0; a < kShapeKinds; ++a) {
    for (int b = 0; b < kShapeKinds; ++b) {
      const auto kind_A = static_cast<ShapeKind>(a);
      const auto kind_B = static_cast<ShapeKind>(b);
      Capability& capability =
          capabilities[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
      if (!HasRecipe(kind_A, kind_B)) {
        capability.reason = NoRecipeReason(kind_A, kind_B);
        continue;
      }
      const bool boxes = kind_A == ShapeKind::kBox && kind_B == ShapeKind::kBox;
      capability.supported = true;
      capability.family = boxes ? "sat" : "closed_form";
      capability.depth = true;
      capability.distance = !boxes;
      capability.normal = true;
      capability.manifold = true;
    }
  }
  return capabilities;
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
